#pragma once

#include <numbers>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace bodkin {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

// Radians per degree.
inline constexpr double degree = std::numbers::pi / 180.0;

// A rigid placement in patient coordinates (LPS, mm). A needle's pose has its origin at the tip, and its third axis
// is the needle's axis, a unit vector from hub to tip.
using Pose = Eigen::Isometry3d;

// The needle's axis, unit, hub to tip.
inline Vec3 needle_axis(const Pose& needle) {
  return needle.linear().col(2);
}

// A needle pose with its tip at `tip` and its axis along `axis` (not necessarily of unit length, not zero). The roll
// about the axis is chosen deterministically.
Pose needle_pose(const Vec3& tip, const Vec3& axis);

// A force (N) and a torque about the needle tip (N mm), both acting on the hand, in patient coordinates.
struct Wrench {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
};

}  // namespace bodkin
