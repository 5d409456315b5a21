#include "forces/pivot.h"

#include <algorithm>
#include <cmath>

#include "forces/model_input.h"

namespace bodkin::forces {

Pivot::Pivot(const anatomy::PivotSettings& settings, double length) : settings_(settings), length_(length) {
  constexpr auto model = "pivot";
  check(settings, model);
  check_range(model, "needle length", length, {10.0, 500.0}, "mm");
}

void Pivot::begin(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  direction_ = direction;
}

Vec3 Pivot::step(const Vec3& tip, const Vec3& axis) const noexcept {
  const double inside = std::min((tip - entry_).dot(axis), length_);  // l1
  const Vec3 turned = direction_ - axis;                              // (V_i - V_c) / L
  const Vec3 across = turned - turned.dot(axis) * axis;
  const double size = across.norm();
  // Written so that NaN fails too.
  if (!(inside > 0.0) || !(size > 1e-12) || !std::isfinite(size)) return Vec3::Zero();
  const double chord = std::min(turned.norm(), 2.0 * std::sin(0.5 * settings_.largest_angle));
  const double correction = settings_.gain * settings_.stiffness * length_ * chord;    // |F_c|
  const double outside = std::max(length_ - inside, settings_.shortest_outside);       // l2
  return across * (-std::min(correction * inside / outside, settings_.limit) / size);  // eq. 2, direction reversed
}

}  // namespace bodkin::forces
