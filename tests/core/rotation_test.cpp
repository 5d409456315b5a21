// Rotations by angles, against Eigen's.
#include "core/rotation.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {
namespace {

Vec3 direction(Random& random) {
  return Vec3(random.normal(), random.normal(), random.normal()).normalized();
}

Eigen::Quaterniond orientation(Random& random) {
  return Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
}

TEST(Rotation, about_an_axis_agrees_with_eigen_and_gives_axis_and_angle_back) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 axis = direction(random);
    const double angle = std::numbers::pi * (2.0 * random.uniform() - 1.0);
    const Mat3 turn = rotation_about(axis, angle);
    EXPECT_LT((turn - Eigen::AngleAxisd(angle, axis).toRotationMatrix()).norm(), 1e-14);
    const AxisAngle back = axis_angle_of(turn);
    EXPECT_NEAR(back.angle, std::abs(angle), 1e-13);
    EXPECT_LT((back.angle * back.axis - angle * axis).norm(), 1e-12);
  }
  EXPECT_EQ(axis_angle_of(Mat3::Identity()).angle, 0.0);
  EXPECT_EQ(axis_angle_of(Mat3::Identity()).axis, Vec3(Vec3::UnitX()));
}

TEST(Rotation, small_and_half_turns_keep_their_axis) {
  for (const double angle : {1e-12, 1e-7, 1e-3, std::numbers::pi - 1e-7}) {
    const AxisAngle back = axis_angle_of(rotation_about(Vec3(0.6, 0.0, 0.8), angle));
    EXPECT_NEAR(back.angle, angle, 1e-9 * angle + 1e-15);
    EXPECT_LT((back.axis - Vec3(0.6, 0.0, 0.8)).norm(), 1e-3);
  }
}

TEST(Rotation, angles_and_parts_of_a_turn_agree_with_eigen) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Quaterniond from = orientation(random), to = orientation(random);
    EXPECT_NEAR(angle_between(from, to), from.angularDistance(to), 1e-13);
    const double part = random.uniform();
    const Eigen::Quaterniond here = interpolate(from, to, part);
    EXPECT_NEAR(here.norm(), 1.0, 1e-14);
    EXPECT_LT((here.toRotationMatrix() - from.slerp(part, to).toRotationMatrix()).norm(), 1e-13);
    EXPECT_NEAR(angle_between(from, here), part * angle_between(from, to), 1e-12);
  }
}

TEST(Rotation, a_part_of_a_turn_begins_and_ends_where_the_turn_does) {
  Random random(3);
  for (const double angle : {0.0, 1e-9, 1e-6, 0.1}) {
    const Eigen::Quaterniond from = orientation(random);
    const Eigen::Quaterniond to(Mat3(rotation_about(direction(random), angle) * from.toRotationMatrix()));
    EXPECT_LT(angle_between(interpolate(from, to, 0.0), from), 1e-14);
    EXPECT_LT(angle_between(interpolate(from, to, 1.0), to), 1e-14);
    EXPECT_NEAR(angle_between(interpolate(from, to, 0.5), from), 0.5 * angle, 1e-10 * angle + 1e-14);
  }
}

}  // namespace
}  // namespace bodkin
