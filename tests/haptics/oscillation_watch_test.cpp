#include "haptics/oscillation_watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "haptics/tremor.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

// Number of detections within a second for a hand that swings at `hertz` and `wide` (mm from the middle), shaken by a
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
  const OscillationWatch watch(fast_oscillation(0.05));
  EXPECT_GE(found(watch, 40.0, 0.1, 0.0, 0.0), 7);
  EXPECT_GE(found(watch, 200.0, 0.1, 0.0, 0.0), 7);
  EXPECT_GE(found(watch, 50.0, 0.04, 0.0, 0.0), 7) << "0.08 mm from side to side";
  EXPECT_EQ(found(watch, 25.0, 1.0, 0.0, 0.0), 0);
  EXPECT_EQ(found(watch, 12.0, 3.0, 0.0, 0.0), 0);
  EXPECT_EQ(found(watch, 100.0, 0.02, 0.0, 0.0), 0);
}

TEST(OscillationWatch, driven_shaking_is_one_that_the_force_feeds) {
  const OscillationWatch watch(driven_oscillation(0.2, 1.0, one_tick));
  EXPECT_GE(found(watch, 15.0, 1.0, 2.0, 0.004), 2) << "a spring that answers late";
  EXPECT_EQ(found(watch, 15.0, 1.0, 2.0, 0.0), 0) << "a spring";
  EXPECT_EQ(found(watch, 15.0, 1.0, 2.0, -0.004), 0) << "a spring with a damper";
  EXPECT_EQ(found(watch, 15.0, 1.0, 1.0, 0.0005), 0) << "a wall that the device renders, held for a tick";
  EXPECT_EQ(found(watch, 15.0, 0.05, 2.0, 0.004), 0) << "small";
  EXPECT_EQ(found(watch, 5.0, 1.0, 2.0, 0.004), 0) << "slow";
  EXPECT_EQ(found(watch, 15.0, 1.0, 2.0, 0.004, 60.0), 0) << "the hand goes somewhere";
}

// A trembling hand leans on a wall that yields, or on tissue that breath carries along: the force is constant or
// changes slowly, and its energy over the open part of a cycle does not shake the hand.
TEST(OscillationWatch, a_tremor_under_a_force_that_stays_or_rises_is_the_hands_own) {
  for (const double push : {0.5, 1.5, 3.0}) {
    for (const double rise : {0.0, 1.0, -2.0}) {  // N, in 3 s
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        for (const OscillationWatch& fresh : {OscillationWatch(driven_oscillation(0.15, 1.0, one_tick)),
                                              OscillationWatch(slow_oscillation(0.15, 1.0, one_tick))}) {
          OscillationWatch watch = fresh;
          Tremor tremor(0.1, one_tick, seed);
          const Vec3 aside = Vec3(0.6, -0.3, 0.74).normalized();
          Vec3 place = Vec3::Zero(), before = Vec3::Zero();
          int count = 0;
          for (int i = 0; i < 30000; ++i) {
            before = place;
            const double slow = rise * std::sin(0.5 * one_tick * i);
            place = tremor.next() + 0.8 * (push + slow) * aside;  // the hand gives way by 0.8 mm/N
            // With a spring of 0.4 N/mm about where the hand is led, without the leak of its tick.
            const Vec3 trembling = 0.5 * (place + before) - 0.8 * (push + slow) * aside;
            const Vec3 force = (push + slow) * aside - 0.4 * trembling;
            count += watch.step(place - before, force, one_tick) ? 1 : 0;
          }
          EXPECT_EQ(count, 0) << push << " " << rise << " " << seed;
        }
      }
    }
  }
}

TEST(OscillationWatch, bursts_with_rests_between_them_do_not_add_up) {
  OscillationWatch watch(fast_oscillation(0.05));
  const Vec3 push(0.0, 0.0, 5.0);
  for (int burst = 0; burst < 5; ++burst) {
    for (int i = 0; i < 60; ++i) EXPECT_FALSE(watch.step(Vec3(0.0, 0.0, i % 20 < 10 ? 0.02 : -0.02), push, one_tick));
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(watch.step(Vec3::Zero(), push, one_tick));
  }
}

TEST(OscillationWatch, a_hand_that_shakes_long_after_the_last_push_shakes_by_itself) {
  OscillationWatch watch(fast_oscillation(0.05));
  watch.step(Vec3::Zero(), Vec3(0.0, 0.0, 5.0), one_tick);
  for (int i = 0; i < 110; ++i) watch.step(Vec3::Zero(), Vec3::Zero(), one_tick);
  for (int i = 0; i < 1000; ++i)
    EXPECT_FALSE(watch.step(Vec3(0.0, 0.0, i % 20 < 10 ? 0.02 : -0.02), Vec3::Zero(), one_tick));
}

TEST(OscillationWatch, a_force_that_changes_its_sign_with_the_hand_shakes_it) {
  OscillationWatch watch(fast_oscillation(0.05));
  int count = 0;
  for (int i = 0; i < 1000; ++i) {
    const double sign = i % 20 < 10 ? 1.0 : -1.0;
    count += watch.step(Vec3(0.0, 0.0, 0.02 * sign), Vec3(0.0, 0.0, 5.0 * sign), one_tick) ? 1 : 0;
  }
  EXPECT_GE(count, 7);
}

TEST(OscillationWatch, without_force_nothing_shakes_the_hand) {
  OscillationWatch watch(fast_oscillation(0.05));
  for (int i = 0; i < 1000; ++i)
    EXPECT_FALSE(watch.step(Vec3(0.0, 0.0, i % 10 < 5 ? 0.1 : -0.1), Vec3::Zero(), one_tick));
}

}  // namespace
}  // namespace bodkin
