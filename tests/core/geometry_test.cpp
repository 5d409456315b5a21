#include "core/geometry.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {
namespace {

TEST(Geometry, a_needle_pose_is_a_rotation_whose_third_axis_is_the_needle) {
  Random random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3 axis(random.normal(), random.normal(), random.normal());
    const Vec3 tip(random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-100, 100));
    const Pose pose = needle_pose(tip, axis);
    EXPECT_EQ(Vec3(pose.translation()), tip);
    EXPECT_LT((needle_axis(pose) - axis.normalized()).norm(), 1e-12);
    EXPECT_LT((pose.linear() * pose.linear().transpose() - Mat3::Identity()).norm(), 1e-12);
    EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-12);
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(needle_pose(Vec3::Zero(), Vec3::Unit(axis)).linear().determinant(), 1.0, 1e-12);
    EXPECT_NEAR(needle_pose(Vec3::Zero(), -Vec3::Unit(axis)).linear().determinant(), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace bodkin
