#include "haptics/oscillation_watch.h"

#include <cmath>
#include <numbers>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;
namespace {

// How often a hand that swings at `hertz` and `wide` (mm from the middle) is found to be shaken within a second, by a
// spring of `stiffness` (N/mm) about a push of 5 N that answers `late` seconds after the hand.
int found(OscillationWatch watch, double hertz, double wide, double stiffness, double late, double drift = 0.0) {
  const auto place = [&](double time) {
    return drift * time + wide * std::sin(2.0 * std::numbers::pi * hertz * time);
  };
  int count = 0;
  for (int i = 1; i <= 1000; ++i) {
    const double time = one_tick * i;
    // The mean of the tick, so that a spring without delay neither gives nor takes.
    const double meanwhile = time - 0.5 * one_tick - late;
    const Vec3 force(0.0, 0.0, 5.0 - stiffness * place(meanwhile));
    count += watch.step(Vec3(0.0, 0.0, place(time) - place(time - one_tick)), force, one_tick) ? 1 : 0;
  }
  return count;
}

TEST(OscillationWatch, fast_shaking_is_above_30_Hz_and_its_swing) {
  const OscillationWatch watch(fast_shaking(0.05));
  EXPECT_GE(found(watch, 40.0, 0.1, 0.0, 0.0), 7);
  EXPECT_GE(found(watch, 200.0, 0.1, 0.0, 0.0), 7);
  EXPECT_GE(found(watch, 50.0, 0.04, 0.0, 0.0), 7) << "0.08 mm from side to side";
  EXPECT_EQ(found(watch, 25.0, 1.0, 0.0, 0.0), 0);
  EXPECT_EQ(found(watch, 12.0, 3.0, 0.0, 0.0), 0);
  EXPECT_EQ(found(watch, 100.0, 0.02, 0.0, 0.0), 0);
}

TEST(OscillationWatch, driven_shaking_is_one_that_the_force_feeds) {
  const OscillationWatch watch(driven_shaking(0.2, 1.0, one_tick));
  EXPECT_GE(found(watch, 15.0, 1.0, 2.0, 0.004), 2) << "a spring that answers late";
  EXPECT_EQ(found(watch, 15.0, 1.0, 2.0, 0.0), 0) << "a spring";
  EXPECT_EQ(found(watch, 15.0, 1.0, 2.0, -0.004), 0) << "a spring with a damper";
  EXPECT_EQ(found(watch, 15.0, 1.0, 1.0, 0.0005), 0) << "a wall that the device renders, held for a tick";
  EXPECT_EQ(found(watch, 15.0, 0.05, 2.0, 0.004), 0) << "small";
  EXPECT_EQ(found(watch, 5.0, 1.0, 2.0, 0.004), 0) << "slow";
  EXPECT_EQ(found(watch, 15.0, 1.0, 2.0, 0.004, 60.0), 0) << "the hand goes somewhere";
}

TEST(OscillationWatch, bursts_with_rests_between_them_do_not_add_up) {
  OscillationWatch watch(fast_shaking(0.05));
  const Vec3 push(0.0, 0.0, 5.0);
  for (int burst = 0; burst < 5; ++burst) {
    for (int i = 0; i < 60; ++i) EXPECT_FALSE(watch.step(Vec3(0.0, 0.0, i % 20 < 10 ? 0.02 : -0.02), push, one_tick));
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(watch.step(Vec3::Zero(), push, one_tick));
  }
}

TEST(OscillationWatch, a_hand_that_shakes_long_after_the_last_push_shakes_by_itself) {
  OscillationWatch watch(fast_shaking(0.05));
  watch.step(Vec3::Zero(), Vec3(0.0, 0.0, 5.0), one_tick);
  for (int i = 0; i < 110; ++i) watch.step(Vec3::Zero(), Vec3::Zero(), one_tick);
  for (int i = 0; i < 1000; ++i)
    EXPECT_FALSE(watch.step(Vec3(0.0, 0.0, i % 20 < 10 ? 0.02 : -0.02), Vec3::Zero(), one_tick));
}

TEST(OscillationWatch, a_force_that_changes_its_sign_with_the_hand_shakes_it) {
  OscillationWatch watch(fast_shaking(0.05));
  int count = 0;
  for (int i = 0; i < 1000; ++i) {
    const double sign = i % 20 < 10 ? 1.0 : -1.0;
    count += watch.step(Vec3(0.0, 0.0, 0.02 * sign), Vec3(0.0, 0.0, 5.0 * sign), one_tick) ? 1 : 0;
  }
  EXPECT_GE(count, 7);
}

TEST(OscillationWatch, without_force_nothing_shakes_the_hand) {
  OscillationWatch watch(fast_shaking(0.05));
  for (int i = 0; i < 1000; ++i)
    EXPECT_FALSE(watch.step(Vec3(0.0, 0.0, i % 10 < 5 ? 0.1 : -0.1), Vec3::Zero(), one_tick));
}

}  // namespace
}  // namespace bodkin
