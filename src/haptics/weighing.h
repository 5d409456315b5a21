#pragma once

#include <cstdint>

#include "core/geometry.h"
#include "core/latest_value.h"
#include "haptics/servo_tick.h"

namespace bodkin {

// A controller that carries the handle of a device which nobody holds, so that it can be weighed: a weak spring to a
// place that glides, with some damping. One observer tells it where to go; step() belongs to the servo's thread, is
// noexcept and allocates nothing. Frames as the device's: use it with a workspace that maps nothing.
class Weighing {
 public:
  static constexpr double stiffness = 0.05;  // N/mm
  static constexpr double damping = 0.002;   // N s/mm
  static constexpr double speed = 20.0;      // mm/s of the place
  static constexpr double most = 4.0;        // N

  // From the next tick on, carry the handle, first where it is; then `above` mm over that.
  void carry(double above) noexcept { above_.write({above, true}); }

  Control step(const ControlInput& input) noexcept;

 private:
  struct Wish {
    double above = 0.0;  // mm
    bool carry = false;
  };

  LatestValue<Wish> above_;
  bool carrying_ = false;
  double gliding_ = 0.0;  // mm above the first place
  Vec3 first_ = Vec3::Zero();
  Vec3 last_ = Vec3::Zero();
  Vec3 velocity_ = Vec3::Zero();  // mm/s
  bool seen_ = false;
};

}  // namespace bodkin
