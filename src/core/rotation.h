#pragma once

#include "core/geometry.h"

namespace bodkin {

// Rotations by angles, with the same bits on every processor: Eigen's own functions call the C library
// (core/repeatable.h says why that does not suffice).

// An angle in rad, 0 to pi, about an axis of length 1.
struct AxisAngle {
  Vec3 axis = Vec3::UnitX();
  double angle = 0.0;
};

// The rotation by `angle` (rad) about `axis`, which has length 1; right-handed.
Mat3 rotation_about(const Vec3& axis, double angle) noexcept;

// Axis and angle of a rotation; the x axis for the identity.
AxisAngle axis_angle_of(const Mat3& rotation) noexcept;

// The angle of the smallest rotation between two orientations, rad, 0 to pi. Both have length 1.
double angle_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) noexcept;

// The smallest rotation from one orientation to another, at constant speed (slerp). Both have length 1.
class Arc {
 public:
  Arc() = default;
  Arc(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) noexcept;
  // The orientation after `part` of the rotation, 0 to 1.
  Eigen::Quaterniond at(double part) const noexcept;

 private:
  Eigen::Quaterniond from_ = Eigen::Quaterniond::Identity(), to_ = from_;
  double angle_ = 0.0, sine_ = 0.0;
};

// The same for a single `part`.
inline Eigen::Quaterniond interpolate(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
                                      double part) noexcept {
  return Arc(from, to).at(part);
}

}  // namespace bodkin
