#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "station/hand_session.h"

#include "fem/moving/body_thread.h"
#include "fem/solid/contact_stream.h"

namespace bodkin::station {

// s of a step of a moving body.
inline constexpr double body_step_time = 1.0 / 60.0;

// A warning to the person that a moving body of `nodes` nodes is too large to move in real time; empty if it is not.
std::string slow_motion_warning(std::size_t nodes);

// Supervises the deformable body of a running session: the thread that computes the contact points of the needle's
// lines (ContactStream), and the reports of a moving body (BodyThread). On the observer's thread.
class BodySupervisor {
 public:
  // `patient`: with the points of its planned line. `length`: mm, largest insertion depth. `kept`: the factorised
  // body, from prepare_body(), or null for a resistance without contact points. `moving`: null for a static body.
  BodySupervisor(std::shared_ptr<const anatomy::Case> patient, std::shared_ptr<const fem::BodyDescription> body,
                 double length, std::shared_ptr<const fem::ContactBody> kept,
                 std::shared_ptr<fem::BodyThread> moving = {});

  // Before the session starts: off the planned path the needle meets contact points of its own line, and a moving
  // body carries it.
  void attach(HandSession& session);
  // To be called often. Returns news for the person, one sentence each.
  std::vector<std::string> update();
  // At the end: the unreported news of update(), and the performance of a moving body in `time` s of the session, one
  // sentence each.
  std::vector<std::string> summary(double time) const;

 private:
  std::vector<std::string> failures_of_points() const;

  std::shared_ptr<const anatomy::Case> patient_;
  std::shared_ptr<const fem::BodyDescription> body_;
  std::shared_ptr<const fem::ContactBody> whole_body_;
  double length_;
  std::unique_ptr<fem::ContactStream> stream_;  // for the needle's own lines
  std::shared_ptr<fem::BodyThread> moving_;
  std::uint64_t steps_ = 0;
  std::uint32_t most_probe_nodes_ = 0;  // largest number held by the probe
  bool failed_ = false;
};

}  // namespace bodkin::station
