#include "forces/pivot.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

// The force with `inside` mm of a 150 mm needle in the body, its hub turned towards +y about the entry.
Vec3 pivot_force(double inside, double angle, const PivotSettings& settings = {}) {
  Pivot pivot(settings, 150.0);
  pivot.begin(Vec3::Zero(), Vec3::UnitZ());
  const Vec3 axis(0.0, -std::sin(angle), std::cos(angle));
  return pivot.step(inside * axis, axis);
}

TEST(Pivot, balances_the_force_at_the_tip_about_the_entry) {
  const double chord = 150.0 * 2.0 * std::sin(degree);
  EXPECT_NEAR(chord, 5.23572, 5e-6);
  EXPECT_NEAR(0.2 * chord, 1.04714, 5e-6);
  EXPECT_NEAR(pivot_force(50.0, 2.0 * degree).norm(), 0.523572, 5e-7);
  EXPECT_NEAR(pivot_force(50.0, 2.0 * degree).norm(), 0.2 * chord * 50.0 / 100.0, 1e-12);
  const double wide = 150.0 * 2.0 * std::sin(5.0 * degree);
  EXPECT_NEAR(wide, 26.1467, 5e-5);
  EXPECT_NEAR(pivot_force(50.0, 10.0 * degree, {.limit = 50.0}).norm(), 2.61467, 5e-6);
  EXPECT_NEAR(pivot_force(100.0, 2.0 * degree, {.limit = 50.0}).norm(), 2.09429, 5e-6);
}

TEST(Pivot, asks_no_more_than_its_limit) {
  EXPECT_DOUBLE_EQ(pivot_force(100.0, 2.0 * degree).norm(), 2.0);
  EXPECT_DOUBLE_EQ(pivot_force(50.0, 10.0 * degree).norm(), 2.0);
  // With 6 N of resistance: 8 N aligned, 6.325 N at right angles; both within a peak of 8.5 N.
  EXPECT_NEAR(std::hypot(6.0, 2.0), 6.325, 5e-4);
}

TEST(Pivot, pushes_a_hub_at_plus_y_towards_minus_y_across_the_needle) {
  const Vec3 hand = pivot_force(50.0, 2.0 * degree);
  EXPECT_LT(hand.y(), 0.0);
  EXPECT_EQ(hand.x(), 0.0);
  EXPECT_NEAR(hand.dot(Vec3(0.0, -std::sin(2.0 * degree), std::cos(2.0 * degree))), 0.0, 1e-15);
}

TEST(Pivot, is_nothing_outside_the_body_and_on_the_line) {
  EXPECT_EQ(pivot_force(-5.0, 2.0 * degree), Vec3::Zero());
  EXPECT_EQ(pivot_force(0.0, 2.0 * degree), Vec3::Zero());
  EXPECT_EQ(pivot_force(50.0, 0.0), Vec3::Zero());
}

TEST(Pivot, holds_the_shaft_in_its_hole) {
  Pivot pivot({.stiffness = 0.2, .gain = 1.5, .limit = 2.0}, 150.0);
  pivot.begin(Vec3(10.0, 20.0, 30.0), Vec3::UnitZ());
  const auto moved = [&](double x, double y) { return pivot.step({10.0 + x, 20.0 + y, 70.0}, Vec3::UnitZ()); };
  EXPECT_TRUE(moved(2.0, -1.0).isApprox(Vec3(-0.6, 0.3, 0.0), 1e-12));
  EXPECT_TRUE(moved(30.0, 0.0).isApprox(Vec3(-2.0, 0.0, 0.0), 1e-12));
  EXPECT_EQ(moved(0.0, 0.0), Vec3::Zero());
}

TEST(Pivot, fades_in_with_the_depth) {
  EXPECT_LT(pivot_force(0.01, 2.0 * degree).norm(), 1e-4);
}

TEST(Pivot, does_not_grow_beyond_the_largest_angle_or_with_the_hub_at_the_skin) {
  const PivotSettings open = {.limit = 100.0};
  EXPECT_NEAR(pivot_force(50.0, 0.3, open).norm(), pivot_force(50.0, 1.2, open).norm(), 1e-9);
  EXPECT_NEAR(pivot_force(149.0, 0.01, open).norm(), 0.2 * 150.0 * 2.0 * std::sin(0.005) * 149.0 / 20.0, 1e-9);
}

TEST(Pivot, conserves_energy_while_the_depth_stays) {
  Pivot pivot({}, 150.0);
  pivot.begin(Vec3::Zero(), Vec3::UnitZ());
  Random random(3);
  const double depth = 60.0;
  double work = 0.0, angle_x = 0.0, angle_y = 0.0;
  Vec3 force_before = Vec3::Zero(), hub_before(0.0, 0.0, depth - 150.0);
  const auto visit = [&](double to_x, double to_y) {
    const double from_x = angle_x, from_y = angle_y;
    for (int i = 1; i <= 500; ++i) {
      angle_x = from_x + (to_x - from_x) * i / 500;
      angle_y = from_y + (to_y - from_y) * i / 500;
      const Vec3 axis = Vec3(angle_x, angle_y, 1.0).normalized();
      const Vec3 now = pivot.step(depth * axis, axis), hub = (depth - 150.0) * axis;
      work -= 0.5 * (now + force_before).dot(hub - hub_before);
      force_before = now;
      hub_before = hub;
    }
  };
  for (int leg = 0; leg < 50; ++leg) visit(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1));
  visit(0.0, 0.0);
  EXPECT_NEAR(work, 0.0, 2e-3);  // of more than 100 N mm that went to and fro
}

TEST(Pivot, is_finite_for_any_input) {
  Pivot pivot({}, 150.0);
  const double values[] = {
      0.0, 1.0, -1e308, 1e308, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  for (const double a : values) {
    for (const double b : values) {
      for (const double c : values) {
        EXPECT_TRUE(pivot.step({a, b, c}, {0.0, 0.1, 0.995}).allFinite());
        EXPECT_TRUE(pivot.step({0.0, 0.0, 50.0}, {a, b, c}).allFinite());
        EXPECT_LE(pivot.step({a, b, c}, {0.0, 0.1, 0.995}).norm(), 2.0 + 1e-12);
      }
    }
  }
}

TEST(Pivot, refuses_settings_outside_their_ranges) {
  EXPECT_THROW(Pivot({.stiffness = -1.0}, 150.0), InputError);
  EXPECT_THROW(Pivot({.limit = NAN}, 150.0), InputError);
  EXPECT_THROW(Pivot({}, 0.0), InputError);
}

}  // namespace
}  // namespace bodkin
