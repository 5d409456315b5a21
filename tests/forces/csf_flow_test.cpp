#include "forces/csf_flow.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::forces;
namespace {

TEST(CsfFlow, drips_as_a_tube_lets_it) {
  const CsfFlow usual({}, 1e-3);
  EXPECT_NEAR(usual.resistance(), 1.26038e-4, 5e-10);
  EXPECT_NEAR(usual.drip(150.0) * 60.0 / 1000.0, 0.700262, 5e-7);  // mL/min
  EXPECT_NEAR(1000.0 / usual.drip(200.0), 64.26, 5e-3);            // s for 1 mL
  const CsfFlow thin_wall({.needle_bore = 0.470}, 1e-3);
  EXPECT_NEAR(thin_wall.drip(150.0) * 60.0 / 1000.0, 1.1745, 5e-5);
  EXPECT_NEAR(1000.0 / thin_wall.drip(200.0), 38.31, 5e-3);  // a bench study measured 40.3 s
  EXPECT_NEAR(1000.0 / CsfFlow({.needle_bore = 0.260}, 1e-3).drip(200.0), 409.0, 0.5);
}

TEST(CsfFlow, manometer_rises_to_the_opening_pressure) {
  CsfFlow flow({}, 0.01);
  EXPECT_NEAR(flow.time_constant(), 22.71, 5e-3);
  const double parts[] = {0.632, 0.865, 0.950};
  const int ticks = static_cast<int>(std::lround(flow.time_constant() / 0.01));
  for (const double part : parts) {
    for (int i = 1; i < ticks; ++i) flow.step_manometer(1.0, false);
    EXPECT_NEAR(flow.step_manometer(1.0, false).height / 145.0, part, 1e-3);
  }
}

TEST(CsfFlow, does_not_depend_on_the_tick) {
  CsfFlow coarse({}, 0.01), fine({}, 0.001);
  for (int i = 0; i < 1000; ++i) coarse.step_manometer(0.7, false);
  for (int i = 0; i < 10000; ++i) fine.step_manometer(0.7, false);
  EXPECT_NEAR(coarse.step_manometer(0.0, false).height, fine.step_manometer(0.0, false).height, 1e-9);
}

TEST(CsfFlow, a_bevel_across_the_dura_slows_it_and_a_stylet_stops_it) {
  CsfFlow whole({}, 0.01), half({}, 0.01), shut({}, 0.01);
  EXPECT_NEAR(half.step_drip(0.5, false).flow, 0.5 * whole.step_drip(1.0, false).flow, 1e-12);
  EXPECT_EQ(shut.step_drip(1.0, true).flow, 0.0);
  EXPECT_EQ(shut.step_manometer(0.0, false).height, 0.0);
  EXPECT_GT(whole.step_drip(1.0, false).collected, 0.0);
}

TEST(CsfFlow, collects_a_millilitre_in_its_time) {
  CsfFlow flow({.opening_pressure = 200.0}, 0.01);
  int ticks = 0;
  while (flow.step_drip(1.0, false).collected < 1000.0) ++ticks;
  EXPECT_NEAR(ticks * 0.01, 64.26, 0.02);
}

// Marmarou's index: what has been lost lowers the pressure to a tenth per PVI.
TEST(CsfFlow, the_pressure_falls_with_what_has_dripped) {
  CsfFlow flow({.pressure_volume_index = 25.0, .times_faster = 100.0}, 0.01);
  while (flow.step_drip(1.0, false).collected < 10000.0) {
  }
  EXPECT_NEAR(flow.pressure(), 145.0 * std::pow(10.0, -0.4), 0.05);
  for (int i = 0; i < 1000; ++i) flow.step_manometer(1.0, false);
  EXPECT_NEAR(flow.step_manometer(1.0, false).height, flow.pressure(), 1e-3) << "the closing pressure";
  const double height = flow.step_manometer(1.0, false).height;
  const double collected = flow.step_drip(1.0, true).collected;
  flow.empty_manometer();
  const CsfState& emptied = flow.step_drip(1.0, true);
  EXPECT_NEAR(emptied.collected - collected, height * 1.767146, 1e-3) << "of a bore of 1.5 mm";
  EXPECT_EQ(emptied.height, 0.0);
}

TEST(CsfFlow, a_hurried_lesson_has_the_same_flow_in_less_time) {
  CsfFlow usual({}, 0.01), hurried({.times_faster = 20.0}, 0.01);
  for (int i = 0; i < 2000; ++i) usual.step_manometer(1.0, false);
  for (int i = 0; i < 100; ++i) hurried.step_manometer(1.0, false);
  EXPECT_NEAR(hurried.step_manometer(0.0, false).height, usual.step_manometer(0.0, false).height, 1e-9);
  EXPECT_NEAR(hurried.step_drip(1.0, false).flow, usual.step_drip(1.0, false).flow, 1e-12);
}

TEST(CsfFlow, is_finite_for_any_opening) {
  CsfFlow flow({}, 1e-3);
  for (const double open : {1e308, -1e308, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_TRUE(std::isfinite(flow.step_manometer(open, false).height));
    EXPECT_LE(flow.step_manometer(open, false).height, 145.0);
    EXPECT_TRUE(std::isfinite(flow.step_drip(open, false).flow));
  }
}

TEST(CsfFlow, refuses_settings_outside_their_ranges) {
  EXPECT_THROW(CsfFlow({.needle_bore = 0.0}, 1e-3), InputError);
  EXPECT_THROW(CsfFlow({.needle_length = 301.0}, 1e-3), InputError);
  EXPECT_THROW(CsfFlow({.opening_pressure = -10.0}, 1e-3), InputError);
}

}  // namespace
}  // namespace bodkin
