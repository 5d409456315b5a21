#pragma once

#include "core/geometry.h"

namespace bodkin {

// Rotations by angles, with the same bits on every processor: Eigen's own call the C library's functions
// (core/repeatable.h says why that is not enough).

// An angle in rad, 0 to pi, about an axis of length 1.
struct AxisAngle {
  Vec3 axis = Vec3::UnitX();
  double angle = 0.0;
};

// The turn by `angle` (rad) about `axis`, which has length 1; right-handed.
Mat3 rotation_about(const Vec3& axis, double angle) noexcept;

// Axis and angle of a rotation; the x axis where nothing turns.
AxisAngle axis_angle_of(const Mat3& rotation) noexcept;

// The angle of the smallest turn between two orientations, rad, 0 to pi. Both of length 1.
double angle_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) noexcept;

// `part` (0 to 1) of the smallest turn from one orientation to another, at constant speed (slerp). Both of length 1.
Eigen::Quaterniond interpolate(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, double part) noexcept;

}  // namespace bodkin
