#include "haptics/round_trip_watch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "tests/haptics/uneven_swing.h"
#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "haptics/oscillation_watch.h"
#include "haptics/tremor.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

constexpr double stiffness = 1.0;  // N/mm, of the device

RoundTripWatch watch_of_device() {
  return {0.075, slow_shaking(0.0, stiffness, one_tick).gain};
}

// N along the motion at a place (mm). What depends on the place alone gives nothing on the way there and back.
using Law = std::function<double(double place)>;
double spring(double place) {
  return -3.0 - stiffness * place;
}
double wall_on_one_side(double place) {
  return -stiffness * std::max(0.0, place);
}
double tissue_that_stiffens(double place) {
  return -0.25 * std::max(0.0, place + 1.0) * std::max(0.0, place + 1.0);
}
double wall_seen_by_an_encoder(double place) {
  return spring(0.05 * std::floor(place / 0.05));
}

// How often it is found in so many seconds, and when first, of a hand that swings unevenly under a force that is
// computed `late` ticks late and held for one.
struct Found {
  int often = 0;
  double first = 0.0;  // s
};
Found found(const Law& law, std::size_t late, double hertz, double seconds, std::uint64_t seed = 1) {
  RoundTripWatch watch = watch_of_device();
  UnevenSwing hand(hertz, 1.0, 0.3, seed);
  std::array<double, 8> places{};  // the newest first
  Found seen;
  for (int i = 1; i <= static_cast<int>(seconds / one_tick); ++i) {
    const double force = law(places[late]), now = hand.step(one_tick);
    if (watch.step(Vec3(0.0, now - places[0], 0.0), Vec3(0.0, force, 0.0), one_tick) && seen.often++ == 0)
      seen.first = one_tick * i;
    std::rotate(places.begin(), places.end() - 1, places.end());
    places[0] = now;
  }
  return seen;
}

TEST(RoundTripWatch, finds_a_hand_that_a_late_spring_drives_however_unevenly_it_swings) {
  for (const Law& law : {Law(spring), Law(wall_seen_by_an_encoder)}) {
    for (const double hertz : {3.2, 5.0, 8.0, 12.0, 18.0}) {
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Found seen = found(law, 2, hertz, 10.0, seed);
        EXPECT_GE(seen.often, 2) << hertz << " Hz";
        EXPECT_LE(seen.first, 0.9 + 6.0 / hertz) << hertz << " Hz";
      }
    }
  }
}

TEST(RoundTripWatch, finds_what_leaves_the_wall_with_every_swing) {
  for (const double hertz : {5.0, 8.0, 12.0}) {
    EXPECT_GE(found(wall_on_one_side, 3, hertz, 60.0).often, 2) << hertz << " Hz";
    EXPECT_GE(found(tissue_that_stiffens, 3, hertz, 60.0).often, 10) << hertz << " Hz";
  }
}

// Half an hour on each wall that a device renders: what a sampled wall leaks is no driving.
TEST(RoundTripWatch, an_uneven_hand_on_a_wall_is_its_own) {
  for (const Law& law :
       {Law(spring), Law(wall_on_one_side), Law(tissue_that_stiffens), Law(wall_seen_by_an_encoder)}) {
    for (const double hertz : {3.2, 4.0, 6.0, 9.0, 12.0}) EXPECT_EQ(found(law, 0, hertz, 360.0).often, 0) << hertz;
  }
}

// Half an hour of trembling of each size, within a wall and at its surface.
TEST(RoundTripWatch, a_tremor_on_a_wall_is_the_hands_own) {
  for (const Law& law : {Law(spring), Law(wall_on_one_side)}) {
    for (const double size : {0.1, 0.3, 1.0}) {
      for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Tremor tremor(size, one_tick, seed);
        RoundTripWatch watch = watch_of_device();
        Vec3 before = tremor.next();
        int often = 0;
        for (int i = 0; i < 180'000; ++i) {
          const Vec3 now = tremor.next();
          often += watch.step(now - before, Vec3(0.0, 0.0, law(before.z() + 0.1)), one_tick) ? 1 : 0;
          before = now;
        }
        EXPECT_EQ(often, 0) << size << " mm, seed " << seed;
      }
    }
  }
}

// Lifting and thrusting of acupuncture, tapping, and stirring: 3 to 5 mm at 2 to 5 Hz against friction and elastic
// tissue.
TEST(RoundTripWatch, a_hand_that_works_is_its_own) {
  for (const double hertz : {2.0, 3.0, 4.0, 5.0}) {
    RoundTripWatch watch = watch_of_device();
    UnevenSwing hand(hertz, 4.0, 0.15, 5);
    double before = 0.0, friction = 0.0;
    for (int i = 0; i < 600'000; ++i) {
      const double now = hand.step(one_tick);
      friction = std::clamp(friction + stiffness * (now - before), -0.8, 0.8);
      const Vec3 force(0.0, 0.0, -1.0 - 0.2 * before - friction);
      EXPECT_FALSE(watch.step(Vec3(0.0, 0.0, now - before), force, one_tick)) << hertz << " Hz, tick " << i;
      before = now;
    }
  }
}

TEST(RoundTripWatch, small_slow_and_unpushed_swings_are_left_to_themselves) {
  const auto often = [](double hertz, double wide, double force) {
    RoundTripWatch watch = watch_of_device();
    int count = 0;
    const auto wave = [&](int tick) { return wide * std::sin(2.0 * std::numbers::pi * hertz * one_tick * tick); };
    for (int i = 5; i < 10'000; ++i)
      count +=
          watch.step(Vec3(wave(i) - wave(i - 1), 0.0, 0.0), Vec3(force - stiffness * wave(i - 5), 0.0, 0.0), one_tick)
              ? 1
              : 0;
    return count;
  };
  EXPECT_GE(often(6.0, 0.5, -3.0), 10);
  EXPECT_EQ(often(6.0, 0.05, -3.0), 0) << "0.1 mm from side to side";
  EXPECT_EQ(often(2.5, 0.5, -3.0), 0) << "slower than 3 Hz";
  RoundTripWatch watch = watch_of_device();
  for (int i = 0; i < 5000; ++i)
    EXPECT_FALSE(watch.step(Vec3(i % 100 < 50 ? 0.02 : -0.02, 0.0, 0.0), Vec3::Zero(), one_tick));
}

TEST(RoundTripWatch, tells_frequency_and_width) {
  RoundTripWatch watch = watch_of_device();
  const auto wave = [](int tick) { return 0.5 * std::sin(2.0 * std::numbers::pi * 6.0 * one_tick * tick); };
  bool seen = false;
  for (int i = 5; i < 5000 && !seen; ++i)
    seen =
        watch.step(Vec3(wave(i) - wave(i - 1), 0.0, 0.0), Vec3(-3.0 - stiffness * wave(i - 5), 0.0, 0.0), one_tick);
  EXPECT_TRUE(seen);
  EXPECT_NEAR(watch.frequency(), 6.0, 0.1);
  EXPECT_NEAR(watch.width(), 1.0, 0.02);
}

}  // namespace
}  // namespace bodkin
