#include "forces/rail.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/repeatable.h"
#include "forces/device_stability.h"
#include "forces/model_input.h"

namespace bodkin::forces {

Rail::Rail(const anatomy::RailSettings& settings) : settings_(settings) {
  check(settings, "rail");
}

void Rail::begin(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  direction_ = direction;
}

Vec3 Rail::torque(const Vec3& axis, double depth) const noexcept {
  const Vec3 turn = axis.cross(direction_);
  const double sine = turn.norm(), cosine = axis.dot(direction_);
  if (!(sine <= 2.0) || !(std::abs(cosine) <= 2.0) || !(depth > 0.0)) return Vec3::Zero();
  const double grown = std::min(depth / settings_.full_depth, 1.0);
  if (sine < 1e-9) {
    if (cosine > 0.0) return Vec3::Zero();
    // Turned by 180 degrees: any axis across the needle will do.
    return direction_.unitOrthogonal() *
           std::min(settings_.torsion * grown * std::numbers::pi, settings_.torque_limit);
  }
  const double size = settings_.torsion * grown * repeatable::atan2(sine, cosine);
  return turn * (std::min(size, settings_.torque_limit) / sine);
}

Wrench Rail::step(const Vec3& tip, const Vec3& axis) const noexcept {
  const double depth = (tip - entry_).dot(direction_);
  const Vec3 aside = tip - entry_ - depth * direction_;  // w
  const double distance = aside.norm();
  if (!(distance <= farthest_depth) || !(std::abs(depth) <= farthest_depth)) return {};
  Wrench wrench;
  if (distance > 0.0) {
    wrench.force = aside * (-std::min(settings_.stiffness * distance, settings_.limit) / distance);
  }
  wrench.torque = torque(axis, depth);
  return wrench;
}

Rail::Rail(const anatomy::Case& patient, const anatomy::RailSettings& settings, double) : Rail(settings) {
  require_stable_across("rail", "stiffness", settings.stiffness, patient.description.device);
}

Wrench Rail::step(const ConstraintInput& needle) const noexcept {
  Wrench wrench = step(needle.tip, needle.axis);
  if (needle.torque_only) wrench.force.setZero();
  return wrench;
}

template <>
std::unique_ptr<AnyConstraint> constraint_with(const anatomy::Case& patient, const anatomy::RailSettings& settings,
                                               double dt) {
  return std::make_unique<ConstraintOf<Rail>>(patient, settings, dt);
}

}  // namespace bodkin::forces
