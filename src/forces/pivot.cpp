#include "forces/pivot.h"

#include <algorithm>
#include <cmath>

#include "core/repeatable.h"
#include "forces/model_input.h"

namespace bodkin::forces {

Pivot::Pivot(const anatomy::PivotSettings& settings, double length) : settings_(settings), length_(length) {
  constexpr auto model = "pivot";
  check(settings, model);
  check_range(model, "needle length", length, {10.0, 500.0}, "mm");
  largest_chord_ = 2.0 * repeatable::sin(0.5 * settings_.largest_angle);
}

void Pivot::begin(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  direction_ = direction;
}

// Only of the rotation: eq. 2, direction reversed. Zero for a needle that points along the frozen direction.
Vec3 Pivot::turning_back(const Vec3& axis, double inside) const noexcept {
  const Vec3 turned = direction_ - axis;  // (V_i - V_c) / L
  const Vec3 across = turned - turned.dot(axis) * axis;
  const double size = across.norm();
  if (size <= 1e-12) return Vec3::Zero();
  const double chord = std::min(turned.norm(), largest_chord_);
  const double correction = settings_.gain * settings_.stiffness * length_ * chord;  // |F_c|
  const double outside = std::max(length_ - inside, settings_.shortest_outside);     // l2
  return across * (-correction * inside / outside / size);
}

Vec3 Pivot::step(const Vec3& tip, const Vec3& axis) const noexcept {
  const Vec3 to_entry = entry_ - tip;
  const double inside = std::min(-to_entry.dot(axis), length_);  // l1
  if (!(inside > 0.0)) return Vec3::Zero();                      // NaN fails too
  const Vec3 from_hole = to_entry - to_entry.dot(axis) * axis;
  const Vec3 force = turning_back(axis, inside) + settings_.gain * settings_.stiffness * from_hole;
  const double size = force.norm();
  if (!std::isfinite(size)) return Vec3::Zero();
  return size > settings_.limit ? Vec3(force * (settings_.limit / size)) : force;
}

template <>
std::unique_ptr<AnyConstraint> constraint_with(const anatomy::Case& patient, const anatomy::PivotSettings& settings,
                                               double dt) {
  return std::make_unique<ConstraintOf<Pivot>>(patient, settings, dt);
}

}  // namespace bodkin::forces
