#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "fem/moving/moving_body.h"

namespace bodkin {

// The deformable body of a patient while a probe presses it: MovingBody on its threads, between the needle's tick,
// the hand that holds the probe, and whoever watches. Its corridor goes where the needle aims: where that leaves the
// one that there is, another one about the needle's own line is prepared. A step that fails ends it for good:
// failed() is true from then on, no corridor comes any more, the probe is to feel nothing and the needle the body at
// rest.
class PressedPatient {
 public:
  // `patient`: with the corridor that prepare_body() gave it, `body`: what that returned. Throws InputError as
  // MovingBody does.
  PressedPatient(const Case& patient, const BodyDescription& body, const PressedBodySettings& settings);

  // Needle's thread, after every tick: s of the session, and HapticTick::node_forces(). Wait-free.
  void tell(double seconds, const NodeForces& of_mesh) noexcept;
  // The probe's thread; wait-free. See MovingBody.
  void move_probe(const std::optional<Pose>& probe) noexcept { moving_->move_probe(probe); }
  const ProbeReading& reading() noexcept { return moving_->reading(); }
  // Any thread.
  bool failed() const noexcept { return moving_->faults() > 0; }

  // One watching thread: the newest corridor, to be given to the tick (HapticTick::refresh_corridor), if it was not
  // told yet.
  std::optional<PreparedCorridor> next_corridor();
  // Likewise, some times a second with the newest needle: leads the corridor to its line where the one before does
  // not cover that. What there is to say of it. `patient`: of the constructor.
  std::optional<std::string> look(const Pose& needle, const Case& patient);
  // Likewise: the newest picture, which stays as it is until the next call.
  const BodyPicture& picture() noexcept { return moving_->picture(); }

 private:
  // Nodes about a line.
  struct Led {
    NeedlePath path;
    CondensedBody body;  // at rest, with the tissues of the voxels; without compliance
  };

  void take(std::shared_ptr<CondensedBody> corridor);
  std::optional<std::string> lead(const NeedlePath& path, const Case& patient);

  BodyDescription description_;
  std::uint32_t corridors_ = 0;           // of the thread that makes them
  std::mutex exchange_;                   // of that thread and the watching one, which both may wait
  Led led_;                               // of both: where the newest corridor is
  std::optional<Led> wanted_;             // of both: where it is led, until it is made
  std::optional<PreparedCorridor> next_;  // of both
  std::optional<NeedlePath> refused_;     // of the watching one: where there can be none
  bool waiting_ = false;                  // likewise: said that one is being made
  std::unique_ptr<MovingBody> moving_;    // the last: its threads use the others
};

}  // namespace bodkin
