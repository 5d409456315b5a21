#include "haptics/stable_stiffness.h"

#include <gtest/gtest.h>

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
  EXPECT_NEAR(found.stiffness, 3.0 * (1.0 + 2.0) / (1.0 + 4.0), 1e-12);
  EXPECT_TRUE(found.is_cut());
}

TEST(StableStiffness, a_vendors_own_loop_keeps_what_is_published) {
  DeviceAbilities device = polled(0.7, 0.001);
  device.owns_loop = true;
  EXPECT_DOUBLE_EQ(stable_stiffness(device, 1000.0).stiffness, 0.7);
  EXPECT_FALSE(stable_stiffness(device, 1000.0).is_cut());
  // A device that was measured to be later than its driver says is offered less, an earlier one not more.
  device.measured_delay = 0.003;
  EXPECT_NEAR(stable_stiffness(device, 1000.0).stiffness, 0.7 * 3.0 / 7.0, 1e-12);
  device.measured_delay = 0.0;
  EXPECT_DOUBLE_EQ(stable_stiffness(device, 1000.0).stiffness, 0.7);
}

TEST(StableStiffness, a_faster_loop_loses_less_to_its_tick) {
  const DeviceAbilities device = polled(5.0, 0.00025);
  EXPECT_LT(stable_stiffness(device, 1000.0).stiffness, stable_stiffness(device, 4000.0).stiffness);
}

TEST(StableStiffness, coarse_counts_without_friction_bound_it_too) {
  DeviceAbilities device = polled(5.0, 0.0);
  device.owns_loop = true;
  device.resolution = 0.05;
  EXPECT_DOUBLE_EQ(stable_stiffness(device, 1000.0).stiffness, 5.0) << "unknown friction";
  EXPECT_NEAR(stable_stiffness(device, 1000.0, 0.05).stiffness, 2.0, 1e-12);
  EXPECT_DOUBLE_EQ(stable_stiffness(device, 1000.0, 0.5).stiffness, 5.0);
}

TEST(StableStiffness, the_guard_is_told_of_the_delay) {
  const GuardSettings settings = guard_settings(polled(5.0, 0.002), 1000.0);
  EXPECT_DOUBLE_EQ(settings.delay, 0.002);
  EXPECT_TRUE(settings.sent_with_next_tick);
  EXPECT_LT(settings.damping, guard_settings(polled(5.0, 0.0), 1000.0).damping);
}

}  // namespace
}  // namespace bodkin
