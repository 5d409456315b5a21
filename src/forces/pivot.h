#pragma once

#include "anatomy/force_settings.h"
#include "core/geometry.h"
#include "forces/constraint_model.h"

namespace bodkin::forces {

// The constraint of a device that can only push, not turn: the puncture O is a pivot, the tissue holds the tip, and
// the device renders at the gimbal (the hub) the force that balances the tip's about O (Kwon et al. 2001, eq. 2,
// Fig. 5 and 9):
//
//   F_c = c k_t (V_i - V_c)          V_i = L u0, V_c = L u
//   F_gimbal = -F_c l1 / l2 + c k_t e     l1 = (tip - O) . u inside, l2 = L - l1 outside; |F_gimbal| <= limit
//   e        = O - tip, its part across u
//
// u0 direction frozen at puncture, u the needle's now, L its length mm, e from the shaft to the hole in the skin.
// Only F_c's direction across u is used; its magnitude is that of the whole chord. The second term is ours: a hole
// does not let a needle move sideways; the paper's needle only turns. The lateral stiffness grows with l1 without a
// force along the needle, as in the paper, so closed paths that tilt at small depth and return at large depth give
// energy: this constraint is **active** (docs/models/pivot.md).
class Pivot {
 public:
  using Settings = anatomy::PivotSettings;

  // Throws InputError for a setting outside its range. `length`: mm, hub to tip, 10 to 500.
  Pivot(const anatomy::PivotSettings& settings, double length);
  Pivot(const anatomy::Case& patient, const anatomy::PivotSettings& settings, double)
      : Pivot(settings, patient.description.needle.length) {}

  // Freezes the pivot at `entry` and the direction (unit).
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // Force on the hand at the hub, LPS N. Zero for input that is not finite.
  Vec3 step(const Vec3& tip, const Vec3& axis) const noexcept;

  void begin(const Vec3& entry, const Vec3& direction, const Vec3&) noexcept { begin(entry, direction); }
  Wrench step(const ConstraintInput& needle) const noexcept {
    return from_hub(step(needle.tip, needle.axis), needle);
  }

 private:
  Vec3 turning_back(const Vec3& axis, double inside) const noexcept;

  anatomy::PivotSettings settings_;
  double length_;
  double largest_chord_ = 0.0;  // of the largest angle, by the needle's length
  Vec3 entry_ = Vec3::Zero();
  Vec3 direction_ = Vec3::UnitZ();
};

}  // namespace bodkin::forces
