#pragma once

#include <span>

#include "anatomy/force_settings.h"
#include "core/geometry.h"

namespace bodkin::forces {

// A force that held the device still at a position.
struct GravitySample {
  Vec3 position = Vec3::Zero();  // mm
  double force = 0.0;            // N upwards
};

// The settings whose affine weight fits the samples best (least squares); one to three samples give a constant.
// Throws InputError when the list is empty or a sample is not finite.
anatomy::GravitySettings fit_gravity(std::span<const GravitySample> samples, const Vec3& up);

// Holds the device's own weight, also in air (Heng et al. 2004, eq. 8 and section 6.1):
//
//   F_G = up clamp(weight + slope . (P - centre), 0, limit)
//
// The paper's one constant is right only at the centre of the workspace, since the weight at the hub depends on the
// pose of the arm; the slope makes it right to first order elsewhere. Prefer the driver's own compensation and never
// apply both. Active by design when the slope has a part across `up`.
class GravityCompensation {
 public:
  // Throws InputError for a setting outside its range.
  explicit GravityCompensation(const anatomy::GravitySettings& settings);

  // Force on the device at `position`, N. Zero for a position that is not finite.
  Vec3 step(const Vec3& position) const noexcept;

 private:
  anatomy::GravitySettings settings_;
};

}  // namespace bodkin::forces
