#include "haptics/stable_stiffness.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"
#include "haptics/device_profiles.h"
#include "haptics/guard_settings.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

DeviceAbilities polled(double stiffness, double delay) {
  DeviceAbilities device;
  device.peak_force = 12.0;
  device.stiffness = stiffness;
  device.delay = delay;
  return device;
}

TEST(StableStiffness, a_loop_that_sends_a_tick_later_is_offered_less) {
  // 2 b / (T (1 + 2 d)): the published stiffness proves b at d = 1, of a loop that answers in its own tick; ours is
  // at d = 2.
  const StableStiffness found = stable_stiffness(polled(3.0, 0.001), 1000.0);
  EXPECT_DOUBLE_EQ(found.published, 3.0);
  EXPECT_NEAR(found.delay, 0.002, 1e-12);
  EXPECT_NEAR(found.axis.y(), 3.0 * (1.0 + 2.0) / (1.0 + 4.0), 1e-12);
  EXPECT_TRUE(found.is_cut());
}

TEST(StableStiffness, a_vendors_own_loop_keeps_what_is_published) {
  DeviceAbilities device = polled(0.7, 0.001);
  device.owns_loop = true;
  EXPECT_DOUBLE_EQ(stable_stiffness(device, 1000.0).weakest(), 0.7);
  EXPECT_FALSE(stable_stiffness(device, 1000.0).is_cut());
  // A device measured to be later than its driver states gets less stiffness, an earlier one not more.
  device.measured_delay = 0.003;
  EXPECT_NEAR(stable_stiffness(device, 1000.0).weakest(), 0.7 * 3.0 / 7.0, 1e-12);
  device.measured_delay = 0.0;
  EXPECT_DOUBLE_EQ(stable_stiffness(device, 1000.0).weakest(), 0.7);
}

TEST(StableStiffness, a_faster_loop_loses_less_to_its_tick) {
  const DeviceAbilities device = polled(5.0, 0.00025);
  EXPECT_LT(stable_stiffness(device, 1000.0).weakest(), stable_stiffness(device, 4000.0).weakest());
}

TEST(StableStiffness, coarse_counts_without_friction_bound_it_too) {
  DeviceAbilities device = polled(5.0, 0.0);
  device.owns_loop = true;
  device.resolution = 0.05;
  EXPECT_DOUBLE_EQ(stable_stiffness(device, 1000.0).weakest(), 5.0) << "unknown friction";
  EXPECT_NEAR(stable_stiffness(device, 1000.0, Vec3::Constant(0.05)).weakest(), 2.0, 1e-12);
  EXPECT_DOUBLE_EQ(stable_stiffness(device, 1000.0, Vec3::Constant(0.5)).weakest(), 5.0);
}

TEST(StableStiffness, each_axis_has_its_own_by_its_friction) {
  DeviceAbilities device = polled(5.0, 0.0);
  device.owns_loop = true;
  device.resolution = 0.05;
  const StableStiffness found = stable_stiffness(device, 1000.0, Vec3(0.05, 0.1, 0.0));
  EXPECT_TRUE(found.axis.isApprox(Vec3(2.0, 4.0, 5.0), 1e-12)) << found.axis.transpose();
  EXPECT_DOUBLE_EQ(found.weakest(), 2.0);
  EXPECT_TRUE(found.is_cut());
}

TEST(StableStiffness, a_slanted_spring_asks_no_axis_for_more_than_it_bears) {
  StableStiffness found;
  found.axis = Vec3(1.0, 2.0, 4.0);
  EXPECT_DOUBLE_EQ(found.along(Vec3::UnitX()), 1.0);
  EXPECT_DOUBLE_EQ(found.along(-Vec3::UnitZ()), 4.0);
  // 1 / (0.5 / 2 + 0.5 / 4) = 8/3; and K n n^T <= diag(axis) in the sense of quadratic forms, just.
  const Vec3 slanted = Vec3(0.0, 1.0, 1.0).normalized();
  EXPECT_NEAR(found.along(slanted), 8.0 / 3.0, 1e-12);
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    const Vec3 n = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    const double spread = random.uniform(0.0, 0.6), stiffness = found.along(n, spread);
    EXPECT_GE(stiffness, found.weakest());
    StableStiffness alike;
    alike.axis = Vec3::Constant(0.7);
    EXPECT_EQ(alike.along(n, spread), 0.7) << "a case that asks for just that is not refused";
    // Every line of the cone, and every displacement: the spring's energy is at most the axes'.
    for (int k = 0; k < 50; ++k) {
      const Vec3 aside = n.cross(Vec3(random.normal(), random.normal(), random.normal())).normalized();
      const double tilt = spread * random.uniform(0.0, 1.0);
      const Vec3 line = std::cos(tilt) * n + std::sin(tilt) * aside;
      const Vec3 moved(random.normal(), random.normal(), random.normal());
      EXPECT_LE(stiffness * std::pow(line.dot(moved), 2), found.axis.dot(moved.cwiseAbs2()) * 1.002);
    }
  }
}

TEST(StableStiffness, the_guard_is_told_of_the_delay) {
  const GuardSettings settings = guard_settings(polled(5.0, 0.002), 1000.0);
  EXPECT_DOUBLE_EQ(settings.delay, 0.002);
  EXPECT_TRUE(settings.sent_with_next_tick);
  EXPECT_LT(settings.damping, guard_settings(polled(5.0, 0.0), 1000.0).damping);
}

}  // namespace
}  // namespace bodkin
