#include "haptics/force_governor.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

constexpr GovernorSettings settings{};

ForceRequest push(double newtons) {
  return {.resistance = newtons, .in_contact = true};
}

// A governor that has settled at a steady force.
ForceGovernor settled(const Vec3& force, const GovernorSettings& with = settings) {
  ForceGovernor governor(with);
  for (int tick = 0; tick < 500; ++tick) governor.step({.constraint = force});
  return governor;
}

TEST(ForceGovernor, a_small_force_passes_untouched_and_unflagged) {
  ForceGovernor governor = settled({0.0, 0.0, -1.0});
  const Vec3 force = governor.step({.resistance = 1.0, .in_contact = true, .constraint = {0.1, 0.0, 0.0}});
  EXPECT_EQ(force, Vec3(0.1, 0.0, -1.0));
  EXPECT_EQ(governor.flags(), 0);
}

TEST(ForceGovernor, a_rise_is_limited_to_200_N_per_second) {
  ForceGovernor governor = settled(Vec3::Zero());
  for (int tick = 1; tick <= 5; ++tick) {
    EXPECT_NEAR(governor.step(push(5.0)).z(), -0.2 * tick, 1e-12);
    EXPECT_TRUE(governor.flags() & force_limit::slew);
    EXPECT_FALSE(governor.flags() & force_limit::ramp);
  }
}

TEST(ForceGovernor, a_force_is_brought_in_at_20_N_per_second_after_a_start_inside_tissue) {
  ForceGovernor governor(settings);
  for (int tick = 1; tick <= 50; ++tick) {
    EXPECT_NEAR(governor.step(push(1.0)).norm(), std::min(1.0, 0.02 * tick), 1e-9);
  }
  EXPECT_NEAR(governor.step(push(1.2)).norm(), 1.2, 1e-12);  // caught up: the ordinary limit holds again
}

TEST(ForceGovernor, a_fall_towards_zero_is_never_delayed) {
  ForceGovernor governor = settled({0.0, 0.0, -1.9});
  EXPECT_NEAR(governor.step(push(0.3)).z(), -0.3, 1e-12);
  EXPECT_EQ(governor.flags(), 0);
}

TEST(ForceGovernor, a_reversal_falls_to_zero_at_once_and_rises_slowly_on_the_other_side) {
  ForceGovernor governor = settled({0.0, 0.0, -1.5});
  EXPECT_NEAR(governor.step({.constraint = {0.0, 0.0, 1.5}}).z(), 0.2, 1e-12);
  EXPECT_TRUE(governor.flags() & force_limit::slew);
}

TEST(ForceGovernor, what_does_not_lead_towards_zero_never_steps_more_than_the_slew) {
  ForceGovernor governor = settled(Vec3::Zero());
  Random random(3);
  Vec3 last = Vec3::Zero();
  for (int tick = 0; tick < 20000; ++tick) {
    const Vec3 wanted(random.normal(), random.normal(), random.normal());
    const Vec3 now = governor.step({.constraint = wanted});
    // The nearest point between the last force and zero, from which the rest is limited.
    const double kept = last.squaredNorm() > 0.0 ? std::clamp(wanted.dot(last) / last.squaredNorm(), 0.0, 1.0) : 0.0;
    EXPECT_LE((now - kept * last).norm(), 0.2 + 1e-12);
    last = now;
  }
}

TEST(ForceGovernor, the_peak_bounds_the_size_and_keeps_the_direction) {
  ForceGovernor governor(settings);
  Vec3 force = Vec3::Zero();
  const Vec3 wanted(6.0, 0.0, 8.0);
  for (int tick = 0; tick < 600; ++tick) force = governor.step({.constraint = wanted});
  EXPECT_NEAR(force.norm(), 6.0, 1e-9);
  EXPECT_NEAR(force.normalized().dot(wanted.normalized()), 1.0, 1e-12);
  EXPECT_TRUE(governor.flags() & force_limit::peak);
}

TEST(ForceGovernor, a_held_overload_comes_down_to_the_continuous_force_without_a_step) {
  ForceGovernor governor(settings);
  double last = 0.0, fastest = 0.0;
  int first_thermal = -1;
  for (int tick = 0; tick < 60000; ++tick) {
    const double now = governor.step(push(5.0)).norm();
    if (tick > 1000) fastest = std::max(fastest, last - now);
    if (first_thermal < 0 && (governor.flags() & force_limit::thermal)) first_thermal = tick;
    EXPECT_LE(governor.mean_square(), 2.0 * 2.0 + 1e-9);
    last = now;
  }
  EXPECT_NEAR(last, 2.0, 0.05);
  EXPECT_LT(fastest, 0.02);        // N per tick: a tenth of the slew limit
  EXPECT_GT(first_thermal, 1000);  // a ligament of 4.7 N is felt: the limit is one of means, not of moments
}

TEST(ForceGovernor, the_continuous_force_may_be_held_for_ever) {
  ForceGovernor governor(settings);
  for (int tick = 0; tick < 100000; ++tick) governor.step(push(1.99));
  EXPECT_NEAR(governor.step(push(1.99)).norm(), 1.99, 1e-6);
}

TEST(ForceGovernor, anything_not_finite_fades_to_zero_within_30_ms_and_stays_there_until_reset) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    ForceGovernor governor = settled({0.0, 0.0, -1.8});
    double last = 1.8;
    for (int tick = 0; tick < 30; ++tick) {
      const Vec3 force = governor.step({.constraint = {bad, 0.0, 0.0}});
      ASSERT_TRUE(force.allFinite());
      EXPECT_NEAR(last - force.norm(), 0.06, 1e-9);  // a straight line: no step that the hand would feel
      EXPECT_TRUE(governor.flags() & force_limit::fault);
      last = force.norm();
    }
    EXPECT_NEAR(last, 0.0, 1e-9);
    for (int tick = 0; tick < 100; ++tick) EXPECT_LT(governor.step(push(1.0)).norm(), 1e-9);
    governor.reset();
    EXPECT_GT(governor.step(push(1.0)).norm(), 0.0);
  }
}

TEST(ForceGovernor, gravity_compensation_costs_the_passivity_controller_nothing) {
  ForceGovernor governor(settings);
  for (int tick = 0; tick < 2000; ++tick) {
    governor.step({.velocity = -100.0, .in_contact = true, .compensation = {0.0, 0.0, 1.0}});
    EXPECT_FALSE(governor.flags() & force_limit::passivity);
  }
  EXPECT_EQ(governor.passivity().energy(), 0.0);
}

TEST(ForceGovernor, an_active_tissue_is_damped_and_flagged) {
  ForceGovernor governor = settled(Vec3::Zero());
  const Vec3 force = governor.step({.resistance = 0.1, .velocity = -10.0, .in_contact = true});
  EXPECT_TRUE(governor.flags() & force_limit::passivity);
  EXPECT_NEAR(force.norm(), 0.0, 1e-12);
}

ForceRequest turn(double newton_millimetres) {
  return {.torque = {newton_millimetres, 0.0, 0.0}};
}

TEST(ForceGovernor, a_torque_rises_at_its_own_slew_falls_at_once_and_keeps_its_peak) {
  ForceGovernor governor = settled(Vec3::Zero());
  governor.step(turn(100.0));
  EXPECT_NEAR(governor.torque().x(), 8.0, 1e-12);
  EXPECT_TRUE(governor.flags() & force_limit::slew);
  for (int tick = 0; tick < 100; ++tick) governor.step(turn(500.0));
  EXPECT_NEAR(governor.torque().x(), 188.0, 1e-9);
  EXPECT_TRUE(governor.flags() & force_limit::peak);
  governor.step(turn(20.0));
  EXPECT_NEAR(governor.torque().x(), 20.0, 1e-12);
}

TEST(ForceGovernor, a_torque_rises_ten_times_slower_while_the_force_is_brought_in) {
  ForceGovernor governor(settings);
  governor.step({.constraint = {0.0, 0.0, -3.0}, .torque = {100.0, 0.0, 0.0}});
  EXPECT_TRUE(governor.flags() & force_limit::ramp);
  EXPECT_NEAR(governor.torque().x(), 0.8, 1e-12);
}

TEST(ForceGovernor, a_device_without_torques_gets_none) {
  GovernorSettings flat;
  flat.peak_torque = 0.0;
  ForceGovernor governor = settled({0.0, 0.0, -1.0}, flat);
  governor.step({.constraint = {0.0, 0.0, -1.0}, .torque = {0.5, 0.0, 0.0}});
  EXPECT_EQ(governor.torque(), Vec3(0.0, 0.0, 0.0));
  EXPECT_FALSE(governor.flags() & force_limit::peak);
}

TEST(ForceGovernor, a_torque_that_is_no_number_fades_force_and_torque_to_zero) {
  ForceGovernor governor(settings);
  for (int tick = 0; tick < 500; ++tick) governor.step({.constraint = {0.0, 0.0, -1.0}, .torque = {50.0, 0.0, 0.0}});
  governor.step({.constraint = {0.0, 0.0, -1.0}, .torque = {std::nan(""), 0.0, 0.0}});
  EXPECT_TRUE(governor.failed());
  EXPECT_TRUE(governor.flags() & force_limit::fault);
  double before = governor.torque().x();
  for (int tick = 0; tick < 31; ++tick) {
    governor.step(turn(100.0));
    EXPECT_LE(governor.torque().x(), before);
    before = governor.torque().x();
  }
  EXPECT_EQ(governor.torque(), Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(governor.step(push(1.0)), Vec3(0.0, 0.0, 0.0));
}

}  // namespace
}  // namespace bodkin
