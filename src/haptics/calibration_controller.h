#pragma once

#include <cstdint>

#include "core/geometry.h"
#include "core/latest_value.h"
#include "haptics/delay_probe.h"
#include "haptics/servo_tick.h"

namespace bodkin::haptics {

// The controller of a calibration. It moves the handle of a device that no hand holds, so that the handle's weight
// and friction can be identified: a weak, damped spring to a target that moves at constant speed. Or it emits the
// pulses of a DelayProbe. One observer sets the target; step() belongs to the servo's thread, is noexcept and
// allocates nothing. Poses are in the device's frame: use it with an identity workspace.
class CalibrationController {
 public:
  static constexpr double stiffness = 0.05;   // N/mm
  static constexpr double damping = 0.002;    // N s/mm
  static constexpr double speed = 20.0;       // mm/s of the target
  static constexpr double force_limit = 4.0;  // N

  // From the next tick on, carries the handle: first at its place, then to `away` from there, mm.
  void carry(const Vec3& away) noexcept { target_.write({away, true}); }

  Control step(const ControlInput& input) noexcept;

  // May also be used by the observer.
  DelayProbe& delay_probe() noexcept { return delay_probe_; }

 private:
  struct Target {
    Vec3 away = Vec3::Zero();  // mm
    bool carry = false;
  };

  LatestValue<Target> target_;
  DelayProbe delay_probe_;
  bool carrying_ = false;
  Vec3 gliding_ = Vec3::Zero();  // mm from the first position
  Vec3 first_ = Vec3::Zero();
  Vec3 last_ = Vec3::Zero();
  Vec3 velocity_ = Vec3::Zero();  // mm/s
  bool seen_ = false;
};

}  // namespace bodkin::haptics
