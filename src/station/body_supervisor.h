#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "station/corridor_keeper.h"
#include "station/hand_session.h"
#include "station/patient_body.h"

#include "fem/solid/contact_stream.h"

namespace bodkin::station {

// s of a step of a moving body.
inline constexpr double body_step_time = 1.0 / 60.0;

// What to tell the person about a moving body of `nodes` nodes that is too large to move in real time; empty: it is
// not.
std::string slow_motion_warning(std::size_t nodes);

// Keeps the deformable body of a running session prepared where the needle aims, on the observer's thread, and
// reports what happens to it: a static body gets more corridors (CorridorKeeper) or, of contact points, a thread that
// computes those of the needle's lines (ContactStream); a moving one is followed and hands its new corridors to the
// tick (PatientBody).
class BodySupervisor {
 public:
  // A static body. See CorridorKeeper.
  BodySupervisor(std::shared_ptr<const anatomy::Case> patient, std::shared_ptr<const fem::BodyDescription> body,
                 double length, std::shared_ptr<const fem::ContactBody> kept);
  // A moving body.
  BodySupervisor(std::shared_ptr<const anatomy::Case> patient, std::shared_ptr<PatientBody> moving);

  // Before the session starts: beside the planned path the needle meets contact points of its own line. Nothing for
  // other bodies.
  void stream_points(HandSession& session);
  // To be called often; acts ten times a second. Returns news for the person, one sentence each.
  std::vector<std::string> update(HandSession& session);
  // How a moving body fared in `time` s of the session, one sentence each; empty for a static one.
  std::vector<std::string> summary(double time) const;

 private:
  void update_static(HandSession& session, std::vector<std::string>& news);
  void update_moving(HandSession& session, std::vector<std::string>& news);

  std::shared_ptr<const anatomy::Case> patient_;
  std::shared_ptr<const fem::BodyDescription> body_;    // of a static body
  std::shared_ptr<const fem::ContactBody> whole_body_;  // of contact points; else null
  double length_ = 0.0;
  std::unique_ptr<fem::ContactStream> stream_;  // of the needle's own lines
  std::optional<CorridorKeeper> keeper_;        // of a static body
  std::shared_ptr<PatientBody> moving_;         // or this
  std::chrono::steady_clock::time_point updated_{};
  std::uint64_t steps_ = 0;
  std::uint32_t corridors_ = 0;         // given to the tick
  std::uint32_t most_probe_nodes_ = 0;  // that the probe ever held
  bool corridor_failed_ = false, failed_ = false;
};

}  // namespace bodkin::station
