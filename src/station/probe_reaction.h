#pragma once

#include <cstdint>

#include "core/geometry.h"
#include "fem/moving/body_thread.h"

namespace bodkin::station {

// An ultrasound probe on a body that moves about sixty times a second (BodyThread), as felt a thousand times a second
// by the hand that holds it.
//
//   F = K (p - x),   p the probe's position in the body, x its position in the hand
//
// The hand drags the probe by a spring K that the device renders. After every step of the body p moves towards the
// position at which the body's force f equals the spring's:
//
//   p <- p + (x + f / K - p) / (1 + k / K),   k an upper bound of the body's stiffness, as estimated so far
//
// At rest F = f. A body of stiffness k is felt with k K / (k + K): every force, as in DeformableShaft, and a smaller
// part of the stiffness the stiffer it is. The immediate stiffness is K, later it is lower, never higher, so that a
// late body takes energy from the hand rather than giving any. Between steps p glides, more slowly the rarer the
// steps are. If the body yields, so that the probe leaves it while the hand is still beyond, p keeps moving as with f
// = 0.
//
// F pushes the probe out along its axis, at most 15 N, and drags it sideways by at most as much (dry skin, see
// ProbePress); there is no torque. Nothing here throws, allocates or reads a clock.
class ProbeReaction {
 public:
  // `dt`: s of a tick. `device_stiffness`: N/mm that the device renders stably.
  ProbeReaction(double dt, double device_stiffness) noexcept;

  // One tick: the force on the hand (N, LPS) that holds the probe at `hand` (LPS, third axis out of its face).
  // `presses` false: the force goes to zero within 0.3 s, and stays there until it is true again.
  Vec3 step(const Pose& hand, const fem::ProbeReading& reading, bool presses) noexcept;

  // The pose of the probe for the body from now on.
  const Pose& probe() const noexcept { return probe_; }
  double force() const noexcept { return force_; }  // N out of the body, along the axis

 private:
  void take(const Vec3& hand, const Vec3& axis, const fem::ProbeReading& reading) noexcept;
  void find_stiffness(const Vec3& axis, const fem::ProbeReading& reading) noexcept;

  double dt_, stiffness_;
  double glide_;         // share of the remaining distance to p covered in a tick
  double body_ = 0.0;    // k, N/mm
  double waited_ = 0.0;  // s since the last reading
  Pose probe_ = Pose::Identity();
  Vec3 goal_ = Vec3::Zero(), felt_ = Vec3::Zero();  // p after the last step, and as it glides there
  Vec3 met_ = Vec3::Zero();                         // p at first contact with the body
  Vec3 last_ = Vec3::Zero();                        // p of the last reading
  double last_force_ = 0.0;                         // N, f of the last reading, without the needle's part
  bool touches_ = false;                            // in contact, or was, and the hand has not moved out since
  double share_ = 0.0;                              // of the force, 0 to 1: ramps in 20 ms
  double force_ = 0.0;
  std::uint64_t steps_ = 0;
};

}  // namespace bodkin::station
