#include "forces/beam.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

Needle gauge24() {
  return {24, 0.5652, 0.3112, 90.0, NeedleTip::whitacre};
}

// Force at the hub, `outside` mm beyond the skin and `aside` mm off the line towards +y, needle parallel to the line.
Vec3 force(double outside, double aside, BeamSettings settings = {}) {
  Beam beam(settings, gauge24(), 1e-3);
  const Vec3 tip(0.0, aside, 90.0 - outside);
  beam.begin(Vec3::Zero(), Vec3::UnitZ(), tip);
  return beam.step(tip, Vec3::UnitZ());
}

TEST(Beam, bends_as_a_tube_of_steel) {
  const double rigidity = bending_stiffness(193000.0, 0.5652, 0.3112);
  EXPECT_NEAR(rigidity / 193000.0, 0.0045489, 5e-8);
  EXPECT_NEAR(rigidity, 877.94, 5e-3);
  EXPECT_NEAR(bending_stiffness(1.0, 0.5652, 0.0), 0.0050093, 5e-8);
  EXPECT_NEAR(bending_stiffness(193000.0, 0.5652, 0.0), 966.8, 5e-2);
  EXPECT_NEAR(bending_stiffness(1.0, 0.550, 0.280), 0.0041901, 5e-8);
}

TEST(Beam, is_a_cantilever_clamped_in_the_skin) {
  const BeamSettings open = {.largest_stiffness = 10.0};
  EXPECT_NEAR(force(90.0, 5.0).norm(), 0.018065, 5e-7);
  EXPECT_NEAR(force(50.0, 5.0).norm(), 0.105353, 5e-7);
  EXPECT_NEAR(force(20.0, 2.0).norm(), 0.658457, 5e-7);
  EXPECT_NEAR(force(10.0, 1.0, {.largest_stiffness = 10.0, .limit = 100.0}).norm(), 2.63383, 5e-6);
  EXPECT_DOUBLE_EQ(force(10.0, 1.0, open).norm(), 2.0);
}

TEST(Beam, stiffens_with_the_cube_of_the_length_outside) {
  const Beam beam({.largest_stiffness = 10.0}, gauge24(), 1e-3);
  EXPECT_NEAR(beam.stiffness(90.0), 0.0036129, 5e-8);
  EXPECT_NEAR(beam.stiffness(50.0), 0.0210706, 5e-8);
  EXPECT_NEAR(beam.stiffness(20.0), 0.329228, 5e-7);
  EXPECT_NEAR(beam.stiffness(10.0), 2.63383, 5e-6);
}

TEST(Beam, stays_below_the_stiffness_of_the_device) {
  const Beam beam({}, gauge24(), 1e-3);
  EXPECT_NEAR(beam.shortest(), 13.8, 0.05);
  EXPECT_NEAR(beam.stiffness(5.0), 1.0, 1e-12);
  EXPECT_NEAR(beam.stiffness(0.0), 1.0, 1e-12);
  EXPECT_NEAR(beam.stiffness(-5.0), 1.0, 1e-12);
}

TEST(Beam, pushes_a_hub_at_plus_y_along_minus_y_only) {
  const Vec3 hand = force(50.0, 5.0);
  EXPECT_LT(hand.y(), 0.0);
  EXPECT_EQ(hand.x(), 0.0);
  EXPECT_EQ(hand.z(), 0.0);
  EXPECT_EQ(force(50.0, 0.0), Vec3::Zero());
}

TEST(Beam, a_stylet_stiffens_it) {
  EXPECT_NEAR(force(50.0, 5.0, {.stylet = true}).norm() / force(50.0, 5.0).norm(), 966.8 / 877.94, 1e-4);
}

TEST(Beam, smooths_the_length_outside_over_a_quick_advance) {
  Beam beam({}, gauge24(), 1e-3);
  beam.begin(Vec3::Zero(), Vec3::UnitZ(), Vec3(0.0, 1.0, 0.0));
  const double first = beam.step(Vec3(0.0, 1.0, 70.0), Vec3::UnitZ()).norm();
  EXPECT_LT(first, 0.01);
  double last = 0.0;
  for (int i = 0; i < 500; ++i) last = beam.step(Vec3(0.0, 1.0, 70.0), Vec3::UnitZ()).norm();
  EXPECT_NEAR(last, 0.329228, 1e-6);
}

TEST(Beam, is_finite_and_bounded_for_any_input) {
  Beam beam({}, gauge24(), 1e-3);
  const double values[] = {0.0,
                           1.0,
                           -300.0,
                           1e308,
                           -1e308,
                           std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()};
  for (const double a : values) {
    for (const double b : values) {
      for (const double c : values) {
        const Vec3 one = beam.step({a, b, c}, Vec3::UnitZ());
        const Vec3 two = beam.step({0.0, 5.0, 50.0}, {a, b, c});
        EXPECT_TRUE(one.allFinite() && two.allFinite());
        EXPECT_LE(std::max(one.norm(), two.norm()), 2.0 + 1e-12);
      }
    }
  }
  EXPECT_TRUE(beam.step({0.0, 1.0, 40.0}, Vec3::UnitZ()).norm() > 0.0);
}

TEST(Beam, refuses_a_needle_or_settings_that_cannot_be) {
  Needle needle = gauge24();
  needle.inner_diameter = needle.outer_diameter;
  EXPECT_THROW(Beam({}, needle, 1e-3), InputError);
  EXPECT_THROW(Beam({.modulus = 193.0}, gauge24(), 1e-3), InputError);
}

}  // namespace
}  // namespace bodkin
