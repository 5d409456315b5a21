#include "forces/line_spring.h"

#include <cmath>
#include <limits>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/sampled_stability.h"

namespace bodkin {

using namespace bodkin::forces;
namespace {

void expect_force(const Vec3& force, double x, double y, double z, double tolerance = 1e-12) {
  EXPECT_NEAR(force.x(), x, tolerance);
  EXPECT_NEAR(force.y(), y, tolerance);
  EXPECT_NEAR(force.z(), z, tolerance);
}

TEST(LineSpring, pulls_straight_back_to_the_line) {
  LineSpring spring({}, 1.0, one_tick);
  spring.begin(Vec3::Zero(), Vec3::UnitZ());
  expect_force(spring.step({3.0, 4.0, 10.0}), -1.5, -2.0, 0.0);
  spring.begin(Vec3::Zero(), Vec3(1.0, 2.0, 2.0) / 3.0);
  expect_force(spring.step({5.0, 1.0, 4.0}), -1.6667, 1.1667, -0.3333, 5e-5);
}

TEST(LineSpring, leaves_a_tip_on_the_line_alone) {
  LineSpring spring({}, 1.0, one_tick);
  const Vec3 entry(10.0, -20.0, 30.0), direction = Vec3(1.0, -2.0, 2.0) / 3.0;
  spring.begin(entry, direction);
  for (const double depth : {-20.0, 0.0, 1.0, 80.0}) {
    EXPECT_LT(spring.step(entry + depth * direction).norm(), 1e-12);
  }
}

TEST(LineSpring, force_has_a_limit_and_keeps_its_direction) {
  LineSpring spring({}, 1.0, one_tick);
  spring.begin(Vec3::Zero(), Vec3::UnitZ());
  expect_force(spring.step({30.0, 40.0, 5.0}), -1.8, -2.4, 0.0);
}

TEST(LineSpring, works_like_a_potential_whatever_way_the_tip_takes) {
  LineSpring spring({.stiffness = 0.5, .damping = 0.0, .limit = 100.0}, 1.0, one_tick);
  spring.begin({1.0, 2.0, 3.0}, Vec3(2.0, 1.0, -2.0) / 3.0);
  double work = 0.0;  // by the hand
  Vec3 last(1.0, 2.0, 3.0);
  Vec3 force = spring.step(last);
  for (int step = 1; step <= 20000; ++step) {
    const double t = step * 2.0 * 3.14159265358979323846 / 20000.0;
    const Vec3 tip =
        Vec3(1.0, 2.0, 3.0) + Vec3(3.0 * std::sin(t), 2.0 * std::sin(2.0 * t), 5.0 * (1.0 - std::cos(t)));
    const Vec3 now = spring.step(tip);
    work -= 0.5 * (force + now).dot(tip - last);
    last = tip;
    force = now;
  }
  EXPECT_NEAR(work, 0.0, 1e-5);
}

TEST(LineSpring, damping_opposes_motion_off_the_line_and_is_bounded_by_the_device) {
  LineSpring spring({.stiffness = 0.5, .damping = 1.0, .limit = 100.0}, 1.0, one_tick);
  EXPECT_DOUBLE_EQ(spring.damping(), damping_allowed(0.5, 1.0, one_tick));
  EXPECT_LE(damping_needed(spring.stiffness(), spring.damping(), one_tick),
            damping_needed(1.0, 0.0, one_tick) + 1e-15);
  spring.begin(Vec3::Zero(), Vec3::UnitZ());
  Vec3 moving;
  for (int tick = 0; tick <= 100; ++tick) moving = spring.step({0.02 * tick, 0.0, 0.1 * tick});
  EXPECT_NEAR(moving.x(), -0.5 * 2.0 - spring.damping() * 20.0, 1e-9);
  EXPECT_NEAR(moving.z(), 0.0, 1e-12);
}

TEST(LineSpring, is_never_stiffer_than_the_device_renders) {
  EXPECT_EQ(LineSpring({.stiffness = 5.0}, 0.8, one_tick).stiffness(), 0.8);
}

TEST(LineSpring, refuses_values_that_make_no_spring) {
  EXPECT_THROW(LineSpring({.stiffness = -1.0}, 1.0, one_tick), InputError);
  EXPECT_THROW(LineSpring({.stiffness = std::numeric_limits<double>::quiet_NaN()}, 1.0, one_tick), InputError);
  EXPECT_THROW(LineSpring({.damping = -0.1}, 1.0, one_tick), InputError);
  EXPECT_THROW(LineSpring({.limit = 0.0}, 1.0, one_tick), InputError);
}

}  // namespace
}  // namespace bodkin
