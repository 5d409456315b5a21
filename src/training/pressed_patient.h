#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "anatomy/case.h"
#include "fem/moving/moving_body.h"

namespace bodkin {

// The deformable body of a patient while a probe presses it: MovingBody on its threads, between the needle's tick,
// the hand that holds the probe, and whoever watches. A step that fails ends it for good: failed() is true from then
// on, no corridor comes any more, the probe is to feel nothing and the needle the body at rest.
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
  // Likewise: the newest picture, which stays as it is until the next call.
  const BodyPicture& picture() noexcept { return moving_->picture(); }

 private:
  void take(std::shared_ptr<CondensedBody> corridor);

  NeedlePath path_;                       // of the corridor
  std::vector<TissueId> tissues_;         // of its nodes, as the voxels have them
  std::vector<std::uint32_t> of_mesh_;    // by node of the mesh: of the corridor, or as many as that has
  std::uint32_t corridors_ = 0;           // of the thread that makes them
  std::mutex exchange_;                   // of that thread and the watching one, which both may wait
  std::optional<PreparedCorridor> next_;  // of both
  std::unique_ptr<MovingBody> moving_;    // the last: its threads use the others
};

}  // namespace bodkin
