#include "haptics/swing_watch.h"

#include <cmath>
#include <utility>
#include <vector>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "core/random.h"
#include "haptics/force_reduction.h"
#include "haptics/tremor.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

// s until a hand that swings at `hertz`, `wide` mm from the middle, is detected as shaken; negative: never in three
// seconds. `fading`: the fraction lost per second.
double found_after(SwingWatch watch, double hertz, double wide, int axis = 2, double fading = 0.0) {
  const auto place = [&](double time) {
    return wide * std::exp(-fading * time) * std::sin(6.283185307 * hertz * time);
  };
  for (int i = 1; i <= 3000; ++i) {
    const double time = one_tick * i;
    Vec3 moved = Vec3::Zero();
    moved[axis] = place(time) - place(time - one_tick);
    if (watch.step(moved, one_tick)) return time;
  }
  return -1.0;
}

TEST(SwingWatch, finds_every_frequency_from_3_to_200_Hz_on_every_axis_within_four_cycles) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double hertz : {3.0, 5.0, 8.0, 12.0, 18.0, 21.0, 30.0, 60.0, 100.0, 150.0, 200.0}) {
      const SwingWatch watch(0.05);
      const double found = found_after(watch, hertz, 0.75 * watch.allowed(hertz), axis);
      EXPECT_GT(found, 0.0) << hertz;
      EXPECT_LT(found, 4.0 / hertz) << hertz;
    }
  }
}

TEST(SwingWatch, lets_a_hand_tremble_and_work) {
  const SwingWatch watch(0.05);
  for (const auto& [hertz, wide] : {std::pair(1.0, 40.0),
                                    {2.0, 30.0},
                                    {4.0, 3.0},
                                    {6.0, 3.0},
                                    {8.0, 2.0},
                                    {11.0, 1.0},
                                    {14.0, 0.3},
                                    {18.0, 0.3}}) {
    EXPECT_LT(found_after(watch, hertz, wide), 0.0) << hertz;
  }
  EXPECT_LT(found_after(watch, 80.0, 0.03), 0.0) << "what an encoder makes of rest";
}

TEST(SwingWatch, lets_a_swing_die_away) {
  const SwingWatch watch(0.05);
  EXPECT_GT(found_after(watch, 25.0, 1.0), 0.0);
  EXPECT_LT(found_after(watch, 25.0, 1.0, 2, 8.0), 0.0) << "a quarter less with each cycle";
  EXPECT_LT(found_after(watch, 10.0, 8.0, 2, 4.0), 0.0);
}

// A hand can swing like this for a moment, but never as evenly for longer than a second.
TEST(SwingWatch, finds_a_small_swing_that_lasts) {
  for (const double hertz : {9.0, 12.0, 15.0, 18.0, 40.0}) {
    SwingWatch watch(0.05);
    double found = 0.0;
    for (int i = 1; i <= 3000 && found == 0.0; ++i) {
      const auto place = [hertz](int tick) { return 0.12 * std::sin(6.283185307 * hertz * one_tick * tick); };
      watch.step(Vec3(0.0, place(i) - place(i - 1), 0.0), one_tick);
      if (watch.lasts()) found = one_tick * i;
    }
    EXPECT_GT(found, 1.2) << hertz;
    EXPECT_LT(found, 1.8) << hertz;
    EXPECT_NEAR(watch.frequency(), hertz, 0.1 * hertz);
  }
}

// s until a small even swing, `wide` mm from the middle, is detected as lasting; 0: not within six seconds.
double found_to_last(double hertz, double wide) {
  SwingWatch watch(0.05);
  const auto place = [&](int tick) { return wide * std::sin(6.283185307 * hertz * one_tick * tick); };
  for (int i = 1; i <= 6000; ++i) {
    watch.step(Vec3(0.0, place(i) - place(i - 1), 0.0), one_tick);
    if (watch.lasts()) return one_tick * i;
  }
  return 0.0;
}

// Swings neither wide nor fast: from a tenth of a millimetre on, down to 3 Hz, within thirteen and a half cycles.
TEST(SwingWatch, finds_a_slow_small_swing_that_lasts_for_twelve_cycles) {
  for (const double hertz : {3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 8.5}) {
    for (const double wide : {0.12, 0.5, 2.0, 5.0}) {
      const double found = found_to_last(hertz, wide);
      EXPECT_GT(found, 12.0 / hertz) << hertz << " Hz, " << wide << " mm";
      EXPECT_LT(found, 13.75 / hertz) << hertz << " Hz, " << wide << " mm";
    }
  }
  EXPECT_GT(found_to_last(4.0, 0.04), 0.0) << "more than one and a half of the least swing";
  EXPECT_EQ(found_to_last(4.0, 0.035), 0.0) << "what an encoder makes of rest";
  EXPECT_EQ(found_to_last(2.0, 2.0), 0.0) << "slower than 3 Hz";
}

// A hand that works to and fro as evenly as people can: 3 % of a period, 10 % of a width, for half an hour
// altogether.
TEST(SwingWatch, a_rhythm_that_a_hand_keeps_does_not_last) {
  for (const double hertz : {3.0, 4.0, 5.0, 6.5, 8.0}) {
    Random random(7);
    SwingWatch watch(0.05);
    double before = 0.0;
    int lasting = 0;
    for (double time = 0.0; time < 360.0;) {
      const double half = 0.5 / hertz * (1.0 + 0.03 * std::sqrt(2.0) * random.normal());
      const double goal = (before > 0.0 ? -1.0 : 1.0) * std::max(0.2, 1.0 + 0.1 * random.normal());
      const double from = before;
      for (double passed = 0.0; passed < half; passed += one_tick) {
        const double now = from + (goal - from) * 0.5 * (1.0 - std::cos(3.14159265 * passed / half));
        watch.step(Vec3(now - before, 0.0, 0.0), one_tick);
        lasting += watch.lasts() ? 1 : 0;
        before = now;
      }
      time += half;
    }
    EXPECT_EQ(lasting, 0) << hertz << " Hz";
  }
}

// Half an hour of trembling on each axis.
TEST(SwingWatch, a_tremor_does_not_last) {
  for (const double size : {0.1, 0.3, 1.0}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      Tremor tremor(size, one_tick, seed);
      SwingWatch watch(0.05);
      Vec3 before = tremor.next();
      int lasting = 0;
      for (int i = 0; i < 60'000; ++i) {
        const Vec3 now = tremor.next();
        watch.step(now - before, one_tick);
        lasting += watch.lasts() ? 1 : 0;
        before = now;
      }
      EXPECT_EQ(lasting, 0) << size << " mm, seed " << seed;
    }
  }
}

TEST(ForceReduction, takes_a_step_every_25_ms_while_the_hand_goes_on) {
  ForceReduction reduction;
  EXPECT_EQ(reduction.begin({22.0, 2.0}), ForceReduction::Step::softer);
  EXPECT_DOUBLE_EQ(reduction.share(), 0.5);
  std::vector<int> steps;
  for (int i = 1; i <= 100; ++i) {
    const double place = std::sin(6.2832 * 22.0 * 0.001 * i), before = std::sin(6.2832 * 22.0 * 0.001 * (i - 1));
    const ForceReduction::Step step = reduction.step(Vec3(0.0, place - before, 0.0), Vec3::Zero(), one_tick);
    EXPECT_EQ(reduction.damps(), step == ForceReduction::Step::damped || !steps.empty());
    if (step != ForceReduction::Step::none) steps.push_back(i);
    if (step == ForceReduction::Step::none_left) break;
  }
  EXPECT_EQ(steps, (std::vector<int>{25, 50}));
}

TEST(ForceReduction, gives_the_force_back_to_a_hand_that_was_calm_for_ten_seconds) {
  ForceReduction reduction;
  reduction.begin({22.0, 2.0});
  for (int i = 0; i < 9900; ++i)
    EXPECT_EQ(reduction.step(Vec3::Zero(), Vec3::Zero(), one_tick), ForceReduction::Step::none);
  EXPECT_DOUBLE_EQ(reduction.share(), 0.5);
  for (int i = 0; i < 1200; ++i) reduction.step(Vec3::Zero(), Vec3::Zero(), one_tick);
  EXPECT_DOUBLE_EQ(reduction.share(), 1.0);
  EXPECT_FALSE(reduction.is_on());
}

TEST(ForceReduction, a_hand_that_shakes_again_before_loses_the_force) {
  ForceReduction reduction;
  reduction.begin({22.0, 2.0});
  for (int i = 0; i < 3000; ++i) reduction.step(Vec3::Zero(), Vec3::Zero(), one_tick);
  EXPECT_EQ(reduction.begin({22.0, 2.0}), ForceReduction::Step::none_left);
}

}  // namespace
}  // namespace bodkin
