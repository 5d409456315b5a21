#pragma once

#include "anatomy/force_settings.h"
#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "forces/events.h"

namespace bodkin {

// The fixed wall that haptic rendering begins with, and the baseline that `tracking_wall` improves on:
//
//   R = max(0, K (x - x_w) + B v)   for x >= x_w,   0 otherwise        (Alamilla, Moreau, Redarce 2018, eq. 2)
//
// x depth of the tip mm, v its speed mm/s, both positive inwards; R pushes the hand out. It has no memory of any
// kind: no puncture, no relaxation, no channel. Entering at speed makes one bounded step B v. docs/models has more.
class SpringDamperWall {
 public:
  // Throws InputError for a setting outside its range.
  explicit SpringDamperWall(const SpringDamperWallSettings& settings);

  // R in N, 0 to `limit`. Unusable motion (model_input.h): 0 and a `fault` event.
  double step(const AxialMotion& motion, TissueId tissue, TickEvents& events) noexcept;
  void reset() noexcept {}

 private:
  SpringDamperWallSettings settings_;
};

}  // namespace bodkin
