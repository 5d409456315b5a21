#include "forces/beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/repeatable.h"
#include "forces/device_stability.h"
#include "forces/model_input.h"

namespace bodkin::forces {

double bending_stiffness(double modulus, double outer_diameter, double inner_diameter) {
  const double outer = outer_diameter * outer_diameter, inner = inner_diameter * inner_diameter;
  return modulus * std::numbers::pi / 64.0 * (outer * outer - inner * inner);
}

Beam::Beam(const anatomy::BeamSettings& settings, const anatomy::Needle& needle, double dt)
    : length_(needle.length), limit_(settings.limit), outside_(settings.smoothing, dt) {
  constexpr auto model = "beam";
  check_tick(model, dt);
  check(settings, model);
  check_range(model, "outer diameter of the needle", needle.outer_diameter, {0.05, 10.0}, "mm");
  check_range(model, "length of the needle", needle.length, {10.0, 500.0}, "mm");
  if (!(needle.inner_diameter >= 0.0 && needle.inner_diameter < needle.outer_diameter)) {
    throw InputError(
        "beam: the bore of the needle is not smaller than its outer diameter; give the inner diameter of the tube");
  }
  rigidity_ =
      bending_stiffness(settings.modulus, needle.outer_diameter, settings.stylet ? 0.0 : needle.inner_diameter);
  shortest_ = repeatable::cbrt(3.0 * rigidity_ / settings.largest_stiffness);
  outside_.reset(length_);
}

void Beam::begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept {
  entry_ = entry;
  direction_ = direction;
  const double outside = length_ - (tip - entry).dot(direction);
  outside_.reset(std::isfinite(outside) ? std::clamp(outside, 0.0, length_) : length_);
}

double Beam::stiffness(double outside) const noexcept {
  const double length = std::max(outside, shortest_);
  return 3.0 * rigidity_ / (length * length * length);  // eq. 4
}

Vec3 Beam::step(const Vec3& tip, const Vec3& axis) noexcept {
  const Vec3 from_entry = tip - length_ * axis - entry_;  // the hub
  const Vec3 offset = from_entry - from_entry.dot(direction_) * direction_;
  const double distance = offset.norm();
  const double depth = (tip - entry_).dot(direction_);
  if (!(distance <= farthest_depth) || !(std::abs(depth) <= farthest_depth)) return Vec3::Zero();
  const double k = stiffness(outside_.step(std::clamp(length_ - depth, 0.0, length_)));
  if (distance == 0.0) return Vec3::Zero();
  return offset * (-std::min(k * distance, limit_) / distance);
}

Beam::Beam(const anatomy::Case& patient, const anatomy::BeamSettings& settings, double dt)
    : Beam(settings, patient.description.needle, dt) {
  require_stable_across("beam", "largest stiffness", settings.largest_stiffness, patient.description.device);
}

template <>
std::unique_ptr<AnyConstraint> constraint_with(const anatomy::Case& patient, const anatomy::BeamSettings& settings,
                                               double dt) {
  return std::make_unique<ConstraintOf<Beam>>(patient, settings, dt);
}

}  // namespace bodkin::forces
