#include "forces/bevel_tip.h"

#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::forces;
namespace {

// Distance along and across the start axis, and the angle to it in degrees.
Vec3 reached(const Pose& tip) {
  return {tip.translation().z(), tip.translation().head<2>().norm(),
          std::acos(std::min(1.0, needle_axis(tip).z())) * 180.0 / std::numbers::pi};
}

void advance(BevelTip& tip, double way, double roll, int steps) {
  for (int i = 0; i < steps; ++i) tip.step(way / steps, roll / steps);
}

TEST(BevelTip, follows_an_arc) {
  for (const int steps : {1, 7, 10000}) {
    BevelTip tip(0.005, 150.0);
    advance(tip, 100.0, 0.0, steps);
    EXPECT_NEAR((reached(tip.tip()) - Vec3(95.8851, 24.4835, 28.6479)).norm(), 0.0, 1e-4) << steps;
  }
}

TEST(BevelTip, flipped_half_way_ends_parallel) {
  BevelTip tip(0.005, 150.0);
  advance(tip, 50.0, 0.0, 500);
  tip.step(0.0, std::numbers::pi);
  advance(tip, 50.0, 0.0, 500);
  EXPECT_NEAR((reached(tip.tip()).head<2>() - Eigen::Vector2d(98.9616, 12.4350)).norm(), 0.0, 1e-4);
  EXPECT_NEAR(reached(tip.tip()).z(), 0.0, 1e-4);
}

TEST(BevelTip, spinning_all_the_way_goes_straight) {
  BevelTip tip(0.005, 150.0);
  advance(tip, 100.0, 200.0 * std::numbers::pi, 20000);
  EXPECT_NEAR(reached(tip.tip()).x(), 100.0, 0.01);
  // A helix about an axis that leans by kappa over the rate of turning.
  EXPECT_NEAR(reached(tip.tip()).y(), 100.0 * 0.005 / (2.0 * std::numbers::pi), 1e-3);
}

TEST(BevelTip, withdrawal_retraces_the_path_whatever_the_roll) {
  BevelTip tip(0.008, 150.0);
  std::vector<Vec3> path;
  for (int i = 0; i < 800; ++i) path.push_back(tip.step(0.1, i % 100 == 0 ? 0.7 : 0.0).translation());
  double worst = 0.0;
  for (int i = 799; i > 0; --i)
    worst = std::max(worst, (tip.step(-0.1, 0.05).translation() - path[static_cast<std::size_t>(i) - 1]).norm());
  EXPECT_LT(worst, 0.003);
  EXPECT_NEAR(tip.cut(), 80.0, 1e-9);
  for (int i = 1; i < 800; ++i)
    worst = std::max(worst, (tip.step(0.1, -0.03).translation() - path[static_cast<std::size_t>(i)]).norm());
  EXPECT_LT(worst, 0.003);  // the channel guides it until its end
  EXPECT_NEAR(tip.length(), 80.0, 1e-9);
}

TEST(BevelTip, a_symmetric_tip_goes_straight_and_stays_a_rotation) {
  BevelTip straight(0.0, 150.0);
  advance(straight, 60.0, 0.0, 100);
  EXPECT_NEAR((straight.tip().translation() - Vec3(0, 0, 60)).norm(), 0.0, 1e-9);
  BevelTip tip(0.01, 300.0);
  Random random(4);
  for (int i = 0; i < 20000; ++i) tip.step(random.uniform(-0.08, 0.1), random.uniform(-0.3, 0.3));
  const Mat3 turn = tip.tip().linear();
  EXPECT_NEAR((turn * turn.transpose() - Mat3::Identity()).norm(), 0.0, 1e-9);
}

TEST(BevelTip, bends_a_beam_on_an_elastic_foundation) {
  const WinklerTip tip = winkler_tip(877.94, 0.05, 0.1);
  EXPECT_NEAR(tip.beta, 0.0614272, 5e-7);
  EXPECT_NEAR(tip.deflection, 0.245709, 5e-6);
  EXPECT_NEAR(bevel_curvature(5.0 * std::numbers::pi / 180.0, 20.0), 0.00437443, 5e-9);
}

TEST(BevelTip, ignores_input_that_is_no_number_and_stops_at_its_memory) {
  BevelTip tip(0.005, 50.0);
  tip.step(10.0, 0.0);
  const Vec3 before = tip.tip().translation();
  tip.step(std::numeric_limits<double>::quiet_NaN(), 0.0);
  tip.step(0.1, std::numeric_limits<double>::infinity());
  EXPECT_EQ(tip.tip().translation(), before);
  tip.step(1000.0, 0.0);
  EXPECT_NEAR(tip.length(), 50.0, 1e-12);
  tip.step(-1000.0, 0.0);
  EXPECT_NEAR(tip.tip().translation().norm(), 0.0, 1e-12);
  EXPECT_THROW(BevelTip(-0.1, 50.0), InputError);
}

}  // namespace
}  // namespace bodkin
