#include "haptics/delay_probe.h"

#include <cmath>
#include <optional>

#include "tests/haptics/device_model.h"
#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "haptics/oscillation_watch.h"
#include "haptics/round_trip_watch.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

std::optional<double> measured(DeviceModel model, std::uint64_t seed) {
  DelayProbe probe;
  Random random(seed);
  probe.begin();
  for (int i = 0; i < 6000 && !probe.is_over(); ++i) {
    const Vec3 trembling(0.0, 0.0, 0.1 * std::sin(6.283 * 9.3 * 0.001 * i));
    model.step(trembling, one_tick);
    model.command(probe.step(model.reading(), one_tick), random);
  }
  EXPECT_TRUE(probe.is_over());
  return probe.delay();
}

TEST(DelayProbe, finds_the_delay_of_a_loosely_held_device_within_eight_tenths_of_a_millisecond) {
  for (const double resolution : {0.01, 0.055}) {
    for (const double delay : {0.0, 0.001, 0.002, 0.003}) {
      for (const bool ours : {false, true}) {
        DeviceModel model;
        model.friction = 0.05;
        model.resolution = resolution;
        model.delay = delay;
        model.sent_with_next_tick = ours;
        model.arm_stiffness = 0.1;
        const std::optional<double> found = measured(model, 5);
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(*found, delay + (ours ? one_tick : 0.0), 0.0008) << resolution;
      }
    }
  }
}

// It drives the hand to and fro on purpose, with force-free pauses long enough not to count as shaking.
TEST(DelayProbe, is_no_uneven_driving) {
  for (const double arm : {0.05, 0.1, 0.3}) {
    DeviceModel model;
    model.friction = 0.02;
    model.resolution = 0.01;
    model.arm_stiffness = arm;
    DelayProbe probe;
    RoundTripWatch trips(0.075, slow_oscillation(0.0, 1.0, one_tick).gain);
    Random random(5);
    probe.begin();
    Vec3 before = model.reading(), force = Vec3::Zero();
    for (int i = 0; i < 8000 && !probe.is_over(); ++i) {
      model.step(Vec3::Zero(), one_tick);
      const Vec3 moved = model.reading() - before;
      EXPECT_FALSE(trips.step(moved, force, one_tick)) << arm << " N/mm, tick " << i;
      before = model.reading();
      force = probe.step(before, one_tick);
      model.command(force, random);
    }
    EXPECT_TRUE(probe.is_over());
  }
}

TEST(DelayProbe, says_nothing_of_a_handle_that_does_not_follow) {
  DeviceModel clamped;
  clamped.friction = 2.0;
  EXPECT_FALSE(measured(clamped, 5).has_value());
}

}  // namespace
}  // namespace bodkin
