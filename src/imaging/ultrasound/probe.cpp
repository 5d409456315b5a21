#include "imaging/ultrasound/probe.h"

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::imaging {

namespace {

constexpr double least_sine = 1e-6;  // of the angle between the direction of view and the marked side

// "(1, 2, 3)"; a zero of either sign is 0.
std::string in_brackets(const Vec3& v) {
  return fmt::format("({:g}, {:g}, {:g})", v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
}

Vec3 unit_direction(const Vec3& direction, const char* what) {
  const double length = direction.norm();
  // False also for non-finite values.
  if (length > 0.0 && length < 1e300) return direction / length;
  throw InputError(
      fmt::format("the probe's {} is {}, expected a direction of finite length that is not zero; give three numbers "
                  "such as 0 1 0",
                  what, in_brackets(direction)));
}

}  // namespace

Pose probe_pose(const Vec3& face, const Vec3& depth, const Vec3& marked) {
  if (!face.allFinite()) {
    throw InputError(fmt::format(
        "the middle of the probe's face is {}, expected three finite numbers; give its place in the patient in mm",
        in_brackets(face)));
  }
  const Vec3 y = unit_direction(depth, "direction of view"), side = unit_direction(marked, "marked side");
  const Vec3 z = side.cross(y);
  if (z.norm() < least_sine) {
    throw InputError(fmt::format(
        "the probe's marked side {} is parallel to its direction of view {}, expected one across the other; turn "
        "either of them",
        in_brackets(marked), in_brackets(depth)));
  }
  Pose pose = Pose::Identity();
  pose.linear().col(2) = z.normalized();
  pose.linear().col(1) = y;
  pose.linear().col(0) = y.cross(pose.linear().col(2));
  pose.translation() = face;
  return pose;
}

}  // namespace bodkin::imaging
