#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "fem/moving/body_thread.h"

namespace bodkin::station {

// The deformable body of a patient that a probe presses: a BodyThread between the needle's tick, the hand that holds
// the probe, and the observer. Where the needle aims outside the corridor, a corridor about the needle's own line is
// prepared. A failed step ends the body for the rest of the session: failed() stays true, no more corridors are made,
// the probe must feel no force, and the needle must meet the body at rest.
class PatientBody {
 public:
  // `patient`: with the corridor that prepare_body() gave it; `body`: what prepare_body() returned. Throws InputError
  // as BodyThread does.
  PatientBody(const anatomy::Case& patient, const fem::BodyDescription& body,
              const fem::BodySolverSettings& settings);

  // Needle's thread, after every tick; wait-free. `seconds`: of the session; `of_mesh`: BodyPort::node_forces().
  void set_needle(double seconds, const fem::NodeForces& of_mesh) noexcept;
  // Probe's thread; wait-free. See BodyThread.
  void move_probe(const std::optional<Pose>& probe) noexcept { thread_->move_probe(probe); }
  const fem::ProbeReading& reading() noexcept { return thread_->reading(); }
  // Any thread.
  bool failed() const noexcept { return thread_->faults() > 0; }

  // Observer's thread: the newest corridor, for BodyPort::refresh_corridor(), if it was not taken before.
  std::optional<anatomy::PreparedCorridor> take_corridor();
  // Observer's thread, several times a second with the newest needle: moves the corridor to the needle's line where
  // the present one does not cover it. Returns news for the person, if any. `patient`: of the constructor.
  std::optional<std::string> follow(const Pose& needle, const anatomy::Case& patient);
  // Observer's thread: the newest snapshot, unchanged until the next call.
  const fem::BodySnapshot& snapshot() noexcept { return thread_->snapshot(); }

 private:
  struct Line {
    anatomy::NeedlePath path;
    anatomy::CondensedBody body;  // the nodes about it at rest, with the tissues of the voxels; without compliance
  };

  void publish(std::shared_ptr<anatomy::CondensedBody> corridor);
  std::optional<std::string> move_to(const anatomy::NeedlePath& path, const anatomy::Case& patient);

  fem::BodyDescription description_;
  std::uint32_t corridors_ = 0;                    // made so far; of the thread that makes them
  std::mutex exchange_;                            // guards present_, wanted_ and next_
  Line present_;                                   // of the newest corridor
  std::optional<Line> wanted_;                     // where the corridor moves, until that is made
  std::optional<anatomy::PreparedCorridor> next_;  // not taken yet
  std::optional<anatomy::NeedlePath> refused_;     // observer's: the last line about which no corridor can be made
  bool waiting_ = false;                           // observer's: a move was announced and not finished
  std::unique_ptr<fem::BodyThread> thread_;        // the last member: its threads use the others
};

}  // namespace bodkin::station
