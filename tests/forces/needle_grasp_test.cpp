#include "forces/needle_grasp.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::forces;
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

// Factor after turning by `turns`, forwards and back again `times` times.
double after(NeedleGrasp& grasp, double turns, int times = 0) {
  double roll = 0.0, factor = grasp.step(0.0);
  const auto go = [&](double to) {
    const double from = roll;
    for (int i = 1; i <= 200; ++i) {
      roll = from + (to - from) * i / 200;
      factor = grasp.step(std::remainder(roll * turn, turn));  // a device reports the angle within one turn
    }
  };
  go(turns);
  for (int i = 0; i < times; ++i) {
    go(0.0);
    go(turns);
  }
  return factor;
}

TEST(NeedleGrasp, turning_one_way_raises_the_pull_out_force_by_167_percent) {
  NeedleGrasp grasp({});
  EXPECT_NEAR(after(grasp, 16.0), 2.67, 1e-3);
  EXPECT_NEAR(grasp.turns(), 16.0, 1e-9);
  NeedleGrasp short_one({});
  EXPECT_NEAR(after(short_one, 2.0), 1.0 + 1.67 * (1.0 - std::exp(-1.0)), 1e-9);
  NeedleGrasp other_way({});
  EXPECT_NEAR(after(other_way, -16.0), 2.67, 1e-3);
}

TEST(NeedleGrasp, turning_to_and_fro_raises_it_by_52_percent) {
  NeedleGrasp grasp({});
  EXPECT_NEAR(after(grasp, 0.25, 60), 1.52, 1e-3);
  NeedleGrasp begun({});
  EXPECT_NEAR(after(begun, 0.25, 3), 1.0 + 0.52 * (1.0 - std::exp(-1.5 / 2.0)), 1e-9);  // 1.5 turns there and back
}

TEST(NeedleGrasp, is_firmer_at_a_point) {
  NeedleGrasp grasp({.point = 1.18});
  EXPECT_DOUBLE_EQ(grasp.step(0.0), 1.18);
}

TEST(NeedleGrasp, does_nothing_without_turning_and_forgets_on_reset) {
  NeedleGrasp grasp({});
  for (int i = 0; i < 100; ++i) EXPECT_EQ(grasp.step(0.3), 1.0);
  after(grasp, 5.0);
  grasp.reset();
  EXPECT_EQ(grasp.step(2.0), 1.0);
}

TEST(NeedleGrasp, stays_bounded_for_any_input) {
  NeedleGrasp grasp({});
  for (const double roll : {1e308, -1e308, std::numeric_limits<double>::infinity(), std::nan(""), 1e5, -1e5}) {
    const double factor = grasp.step(roll);
    EXPECT_GE(factor, 1.0);
    EXPECT_LE(factor, 2.67);
  }
}

TEST(NeedleGrasp, refuses_settings_outside_their_ranges) {
  EXPECT_THROW(NeedleGrasp({.one_way = 0.1, .two_way = 0.5}), InputError);
  EXPECT_THROW(NeedleGrasp({.turns_to_wind = 0.0}), InputError);
}

}  // namespace
}  // namespace bodkin
