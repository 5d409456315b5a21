#include "forces/rail.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

Rail rail(const RailSettings& settings = {}) {
  Rail made(settings);
  made.begin(Vec3(10.0, 0.0, 0.0), Vec3::UnitZ());
  return made;
}

Vec3 tilted(double angle) {
  return {std::sin(angle), 0.0, std::cos(angle)};
}

TEST(Rail, turns_a_tilted_needle_back_with_the_depth) {
  const Vec3 torque = rail().torque(tilted(5.0 * degree), 20.0);
  EXPECT_NEAR(torque.norm(), 43.6332, 5e-5);
  // d_c leans to +x; turning it back to z is a turn about -y.
  EXPECT_NEAR(torque.y(), -torque.norm(), 1e-12);
  EXPECT_NEAR(rail().torque(tilted(5.0 * degree), 40.0).norm(), 87.2665, 1e-4);
  EXPECT_NEAR(rail().torque(tilted(5.0 * degree), 90.0).norm(), 87.2665, 1e-4);
  EXPECT_EQ(rail().torque(tilted(5.0 * degree), 0.0), Vec3::Zero());
  EXPECT_EQ(rail().torque(tilted(5.0 * degree), -3.0), Vec3::Zero());
}

TEST(Rail, is_the_vector_part_of_the_quaternion_that_turns_the_needle_back) {
  const Vec3 axis = Vec3(0.2, -0.3, 0.9).normalized();
  const Vec3 about = axis.cross(Vec3::UnitZ());  // q = (1 + cosine, about) / |...|
  const Eigen::Quaterniond turn = Eigen::Quaterniond(1.0 + axis.z(), about.x(), about.y(), about.z()).normalized();
  const Eigen::AngleAxisd angle_axis(turn);
  const Vec3 torque = rail({.torque_limit = 1e4}).torque(axis, 40.0);
  EXPECT_NEAR((torque - 1000.0 * angle_axis.angle() * angle_axis.axis()).norm(), 0.0, 1e-9);
}

TEST(Rail, pulls_the_tip_to_the_line) {
  const Wrench wrench = rail().step(Vec3(10.0, 2.0, 30.0), Vec3::UnitZ());
  EXPECT_NEAR((wrench.force - Vec3(0.0, -1.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(wrench.torque, Vec3::Zero());
  EXPECT_NEAR(rail().step(Vec3(10.0, 20.0, 30.0), Vec3::UnitZ()).force.norm(), 3.0, 1e-12);
}

TEST(Rail, projects_a_proxy_onto_the_line) {
  EXPECT_NEAR((rail().project(Vec3(12.0, -7.0, 33.0)) - Vec3(10.0, 0.0, 33.0)).norm(), 0.0, 1e-12);
}

TEST(Rail, leaves_roll_free) {
  const Pose pose = needle_pose(Vec3(10.0, 0.0, 30.0), tilted(0.1));
  const Vec3 before = rail().torque(needle_axis(pose), 30.0);
  const Pose rolled = pose * Eigen::AngleAxisd(1.0, Vec3::UnitZ());
  EXPECT_NEAR((rail().torque(needle_axis(rolled), 30.0) - before).norm(), 0.0, 1e-9);
  EXPECT_NEAR(before.dot(Vec3::UnitZ()), 0.0, 1e-12);
}

TEST(Rail, saturates_at_the_torque_of_the_device_and_right_round) {
  EXPECT_NEAR(rail().torque(tilted(60.0 * degree), 40.0).norm(), 188.0, 1e-9);
  const Vec3 back = rail().torque(-Vec3::UnitZ(), 40.0);
  EXPECT_NEAR(back.norm(), 188.0, 1e-9);
  EXPECT_NEAR(back.dot(Vec3::UnitZ()), 0.0, 1e-12);
}

TEST(Rail, is_finite_for_any_input) {
  const double values[] = {0.0,
                           1.0,
                           -1.0,
                           1e308,
                           -1e308,
                           std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()};
  for (const double a : values) {
    for (const double b : values) {
      for (const double c : values) {
        const Wrench one = rail().step({a, b, c}, Vec3::UnitZ()), two = rail().step({10.0, 1.0, 20.0}, {a, b, c});
        EXPECT_TRUE(one.force.allFinite() && one.torque.allFinite() && two.torque.allFinite());
        EXPECT_LE(two.torque.norm(), 188.0 * (1.0 + 1e-12));
      }
    }
  }
}

TEST(Rail, refuses_settings_outside_their_ranges) {
  EXPECT_THROW(Rail({.torsion = -1.0}), InputError);
  EXPECT_THROW(Rail({.full_depth = 0.0}), InputError);
}

}  // namespace
}  // namespace bodkin
