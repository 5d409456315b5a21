#include "forces/line_spring.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "core/sampled_stability.h"

namespace bodkin::forces {

LineSpring::LineSpring(const anatomy::LineSpringSettings& settings, double device_stiffness, double dt)
    : stiffness_(std::min(settings.stiffness, device_stiffness)),
      damping_(std::min(settings.damping, damping_allowed(stiffness_, device_stiffness, dt))),
      limit_(settings.limit),
      dt_(dt),
      gain_(OnePole(50.0, dt).gain()) {
  check(settings, "line_spring");
}

void LineSpring::begin(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  direction_ = direction;
  offset_.setZero();
  rate_.setZero();
}

Vec3 LineSpring::step(const Vec3& tip) noexcept {
  const Vec3 from_entry = tip - entry_;
  const Vec3 offset = from_entry - from_entry.dot(direction_) * direction_;
  rate_ += gain_ * ((offset - offset_) / dt_ - rate_);
  offset_ = offset;
  const Vec3 force = -stiffness_ * offset - damping_ * rate_;  // eq. 9
  const double size = force.norm();
  return size > limit_ ? Vec3(force * (limit_ / size)) : force;
}

template <>
std::unique_ptr<AnyConstraint> constraint_with(const anatomy::Case& patient,
                                               const anatomy::LineSpringSettings& settings, double dt) {
  return std::make_unique<ConstraintOf<LineSpring>>(patient, settings, dt);
}

}  // namespace bodkin::forces
