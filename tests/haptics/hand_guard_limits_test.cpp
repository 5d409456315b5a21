// The limits of HandGuard: peak, slew, heat, workspace, and arbitrary input.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/haptics/guard_rig.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

const Vec3 nothing = Vec3::Zero();

TEST(HandGuardLimits, the_peak_is_nine_tenths_of_the_nominal_and_keeps_the_direction) {
  GuardRig rig;
  rig.push({6.0, 0.0, 8.0});
  EXPECT_NEAR(rig.guard.applied().force.norm(), 9.0, 1e-9);
  EXPECT_NEAR(rig.guard.applied().force.x() / rig.guard.applied().force.z(), 0.75, 1e-9);
  EXPECT_TRUE(rig.guard.limits() & (1U << static_cast<unsigned>(GuardReason::peak)));
}

TEST(HandGuardLimits, the_users_limit_counts_where_it_is_smaller) {
  GuardSettings settings = GuardRig::example();
  settings.user_force = 2.0;
  GuardRig rig(settings);
  rig.push({6.0, 0.0, 8.0});
  EXPECT_NEAR(rig.guard.applied().force.norm(), 2.0, 1e-9);
}

TEST(HandGuardLimits, a_rise_is_limited_to_half_a_newton_per_millisecond_and_a_drop_is_not_delayed) {
  GuardRig rig;
  rig.push(nothing);
  for (int i = 1; i <= 5; ++i) EXPECT_NEAR(rig.tick(Vec3(0.0, 0.0, 4.0)).force.z(), 0.5 * i, 1e-12);
  EXPECT_EQ(rig.count(GuardReason::slew), 1) << "one event for one spell";
  for (int i = 0; i < 10; ++i) rig.tick(Vec3(0.0, 0.0, 4.0));
  EXPECT_NEAR(rig.tick(Vec3(0.0, 0.0, 0.4)).force.z(), 0.4, 1e-12);
  EXPECT_NEAR(rig.tick(Vec3(0.0, 0.0, -4.0)).force.z(), -0.5, 1e-12) << "a reversal rises slowly on the other side";
}

TEST(HandGuardLimits, torques_have_a_peak_and_a_slew_of_their_own) {
  GuardRig rig;
  rig.push(nothing);
  for (int i = 1; i <= 5; ++i) {
    EXPECT_NEAR(rig.tick(Wrench{nothing, Vec3(0.0, 500.0, 0.0)}).torque.y(), 20.0 * i, 1e-9);
  }
  for (int i = 1; i <= 20; ++i) rig.tick(Wrench{nothing, Vec3(0.0, 500.0, 0.0)});
  EXPECT_NEAR(rig.guard.applied().torque.norm(), 180.0, 1e-9);
  EXPECT_EQ(rig.count(GuardReason::torque_peak), 1);

  GuardSettings without = GuardRig::example();
  without.peak_torque = 0.0;
  GuardRig plain(without);
  plain.push(nothing);
  EXPECT_TRUE(plain.tick(Wrench{nothing, Vec3(0.0, 500.0, 0.0)}).torque.isZero(0.0));
  EXPECT_EQ(plain.count(GuardReason::torque_peak), 0) << "a device without torques is at no fault";
}

TEST(HandGuardLimits, an_axis_that_gives_energy_is_damped_and_says_so) {
  GuardRig rig;
  rig.push({2.0, 0.0, 0.0});
  const double before = rig.guard.energy().x();
  for (int i = 0; i < 50; ++i) {
    rig.device.hand.translation().x() += 0.02;  // 20 mm/s, along with the force
    rig.tick(Vec3(2.0, 0.0, 0.0));
  }
  EXPECT_NEAR(rig.guard.applied().force.x(), 2.0 - 0.002 * 20.0, 1e-3);
  EXPECT_NEAR(rig.guard.energy().x() - before, -50 * 0.02 * 1.97, 0.05) << "N mm that the hand has got";
  EXPECT_EQ(rig.count(GuardReason::passivity), 1);
  EXPECT_TRUE(rig.guard.limits() & (1U << static_cast<unsigned>(GuardReason::passivity)));
  // Moving against the force, the hand returns the energy, and the damping ends.
  for (int i = 0; i < 60; ++i) {
    rig.device.hand.translation().x() -= 0.02;
    rig.tick(Vec3(2.0, 0.0, 0.0));
  }
  EXPECT_DOUBLE_EQ(rig.guard.applied().force.x(), 2.0);
  EXPECT_GT(rig.guard.energy().x(), 0.0);
}

TEST(HandGuardLimits, the_mean_load_never_passes_the_continuous_force) {
  GuardRig rig;
  rig.push(nothing);
  double largest = 0.0;
  for (int i = 0; i < 120000; ++i) {
    rig.tick(Vec3(0.0, 0.0, 8.0));
    largest = std::max(largest, rig.guard.mean_square());
  }
  EXPECT_LE(largest, 9.0 + 1e-9);
  EXPECT_NEAR(rig.guard.applied().force.z(), 3.0, 0.3);
  EXPECT_EQ(rig.count(GuardReason::thermal), 1);
}

TEST(HandGuardLimits, hot_motors_get_the_continuous_force_and_then_none) {
  GuardRig rig;
  rig.push({0.0, 0.0, 8.0});
  const auto at = [&](double temperature) {
    rig.device.temperature = temperature;
    Vec3 force = nothing;
    for (int i = 0; i < 30; ++i) force = rig.tick(Vec3(0.0, 0.0, 8.0)).force;
    return force.z();
  };
  EXPECT_NEAR(at(0.7), 8.0, 1e-9);
  EXPECT_NEAR(at(0.825), 6.0, 1e-9);
  EXPECT_NEAR(at(0.9), 3.0, 1e-9);
  EXPECT_NEAR(at(0.95), 1.5, 1e-9);
  EXPECT_NEAR(at(1.0), 0.0, 1e-9);
  EXPECT_NEAR(at(7.0), 0.0, 1e-9);
  EXPECT_GE(rig.count(GuardReason::hot), 1);
}

TEST(HandGuardLimits, the_force_goes_to_zero_over_10_mm_outside_the_workspace) {
  GuardRig rig;
  rig.push({0.0, 0.0, 4.0});
  double last = 4.0;
  for (double y = 0.0; y < 95.0; y += 0.1) {
    rig.device.hand.translation().y() = y;
    const double force = rig.tick(Vec3(0.0, 0.0, 4.0)).force.z();
    EXPECT_NEAR(force, 4.0 * std::clamp(1.0 - (y - 80.0) / 10.0, 0.0, 1.0), 1e-6) << y;
    EXPECT_LE(force, last + 1e-9);
    last = force;
  }
  EXPECT_EQ(rig.count(GuardReason::workspace), 1);
  EXPECT_TRUE(rig.guard.is_armed());
}

TEST(HandGuardLimits, come_from_what_a_device_reports) {
  DeviceAbilities touch;
  touch.peak_force = 3.3;
  touch.resolution = 0.055;
  touch.workspace_low = Vec3(-80.0, -60.0, -35.0);
  touch.workspace_high = -touch.workspace_low;
  const GuardSettings settings = guard_settings(touch, 1000.0);
  EXPECT_NO_THROW(bodkin::check(settings, "device"));
  EXPECT_NEAR(HandGuard(settings).bound(), 2.97, 1e-12);
  EXPECT_NEAR(settings.continuous_force, 0.495, 1e-12) << "careful where it is unknown";
  EXPECT_NEAR(settings.oscillation_amplitude, 0.1045, 1e-12);
  EXPECT_NO_THROW(HandGuard(guard_settings({}, 1000.0))) << "a device without forces";
}

// Any input in any order.
TEST(HandGuardLimits, the_wrench_is_finite_and_within_the_bounds_whatever_comes_in) {
  const double wild[] = {0.0,         1e-300, 1.0, -1.0, 50.0, 1e6, 1e200, std::numeric_limits<double>::infinity(),
                         std::nan("")};
  Random random(17);
  const auto any = [&] {
    return random.uniform() < 0.6 ? random.uniform(-20.0, 20.0) : wild[random.next() % std::size(wild)];
  };
  int armed_ticks = 0;
  GuardRig rig;
  for (int i = 0; i < 200000; ++i) {
    if (i % 2000 == 0) {
      rig.device = DeviceState{};
      rig.guard.arm();
    }
    const bool calm = i % 2000 < 400 + static_cast<int>(random.next() % 1800);
    Wrench wanted{Vec3(random.uniform(-20.0, 20.0), any() > 15.0 ? 9.0 : 0.0, 0.0), Vec3(0.0, 300.0, 0.0)};
    double age = 0.0, dt = 0.001;
    if (i % 2000 < 70) wanted = {};
    if (!calm) {
      wanted = {Vec3(any(), any(), any()), Vec3(any(), any(), any())};
      if (random.uniform() < 0.05) age = any();
      if (random.uniform() < 0.05) dt = any();
      if (random.uniform() < 0.02) rig.device.temperature = any();
      if (random.uniform() < 0.02) rig.device.velocity = Vec3(any(), any(), any());
      if (random.uniform() < 0.01) rig.device.held = !rig.device.held;
      if (random.uniform() < 0.002) rig.device.hand.translation() = Vec3(any(), any(), any());
      if (random.uniform() < 0.002) rig.device.hand.linear()(0, 1) = any();
      if (random.uniform() < 0.002) rig.device.fault = static_cast<DeviceFault>(random.next() % 14);
      if (random.uniform() < 0.01) rig.guard.arm();
      if (random.uniform() < 0.002) rig.guard.disarm();
    }
    const Wrench applied = rig.tick(wanted, age, dt);
    ASSERT_TRUE(applied.force.allFinite() && applied.torque.allFinite()) << i;
    ASSERT_LE(applied.force.norm(), 9.0 * (1.0 + 1e-12)) << i;
    ASSERT_LE(applied.torque.norm(), 180.0 * (1.0 + 1e-12)) << i;
    ASSERT_TRUE(rig.device.fault == DeviceFault::none || applied.force.isZero(0.0)) << i;
    armed_ticks += rig.guard.is_armed() ? 1 : 0;
    rig.events.clear();
  }
  EXPECT_GT(armed_ticks, 20000) << "the guard was armed for a good part of it";
}

}  // namespace
}  // namespace bodkin
