#pragma once

#include "anatomy/force_settings.h"
#include "core/geometry.h"
#include "forces/constraint_model.h"

namespace bodkin::forces {

// The needle's body in tissue (Faerber, Heller, Handels, section 2.1.4, Fig. 5): at the skin puncture a line (p, d)
// is stored. The proxy is projected onto it, so that the spring k pulls the tip towards it; and a torque turns the
// needle back to d, growing with depth:
//
//   x_p <- p + ((x_p - p) . d) d
//   F_across = -k w,   w = (tip - p) - ((tip - p) . d) d                              |F_across| <= limit
//   tau = kappa0 g theta a/|a|,   a = d_c x d,   theta = atan2(|a|, d_c . d),   g = clamp(depth / depth_ref, 0, 1)
//
// Needle direction d_c, depth mm along the line. The torque is the vector part of the quaternion that turns d_c to d;
// roll is free. g grows with depth at no cost along the needle, as in the paper: **active**, see docs/models/rail.md.
class Rail {
 public:
  using Settings = anatomy::RailSettings;

  // Throws InputError for a setting outside its range.
  explicit Rail(const anatomy::RailSettings& settings);
  // From a patient: also refuses settings that the device cannot render stably.
  Rail(const anatomy::Case& patient, const anatomy::RailSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // The point of the line nearest to `proxy`.
  Vec3 project(const Vec3& proxy) const noexcept { return entry_ + (proxy - entry_).dot(direction_) * direction_; }
  // Lateral force at the tip and torque, on the hand. Zero for input that is not finite. A resistance with a proxy of
  // its own (`volume_proxy`) uses project() instead of the force, and only the torque from here.
  Wrench step(const Vec3& tip, const Vec3& axis) const noexcept;
  void begin(const Vec3& entry, const Vec3& direction, const Vec3&) noexcept { begin(entry, direction); }
  Wrench step(const ConstraintInput& needle) const noexcept;
  // Only the torque, N mm.
  Vec3 torque(const Vec3& axis, double depth) const noexcept;

 private:
  anatomy::RailSettings settings_;
  Vec3 entry_ = Vec3::Zero();
  Vec3 direction_ = Vec3::UnitZ();
};

}  // namespace bodkin::forces
