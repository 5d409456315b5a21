#include "core/geometry.h"

namespace bodkin {

Pose needle_pose(const Vec3& tip, const Vec3& axis) {
  const Vec3 z = axis.normalized();
  // The coordinate axis that is least aligned with the needle gives the best conditioned frame.
  Eigen::Index least = 0;
  z.cwiseAbs().minCoeff(&least);
  const Vec3 y = z.cross(Vec3::Unit(least)).normalized();
  Pose pose = Pose::Identity();
  pose.linear().col(0) = y.cross(z);
  pose.linear().col(1) = y;
  pose.linear().col(2) = z;
  pose.translation() = tip;
  return pose;
}

}  // namespace bodkin
