#include "haptics/round_trip_watch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

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
  return {0.075, slow_oscillation(0.0, stiffness, one_tick).gain};
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

// Number of detections in so many seconds, and time of the first, for a hand that swings unevenly under a force
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

// Half an hour on each wall that a device renders: the leak of a sampled wall does not count as driving.
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

// A hand that swings evenly, 1 mm from side to side about a place that may move, under a force whose part along the
// motion is `drive` N (in phase with the speed) at those times at which `is_driven`. When it was found, s.
struct SwingMotion {
  double hertz = 10.0;
  double base = -3.0, drive = 0.3;  // N
  std::function<bool(double time)> is_driven = [](double) { return true; };
  std::function<double(double time)> middle = [](double) { return 0.0; };  // mm
  std::function<bool(double time)> rests = [](double) { return false; };   // neither moves nor is pushed
  double seconds = 20.0;

  std::vector<double> found() const {
    RoundTripWatch watch = watch_of_device();
    std::vector<double> times;
    double phase = 0.0, before = middle(0.0);
    for (int i = 1; i <= static_cast<int>(seconds / one_tick); ++i) {
      const double time = one_tick * i;
      const bool still = rests(time);
      if (!still) phase += 2.0 * std::numbers::pi * hertz * one_tick;
      const double now = middle(time) + 0.5 * std::sin(phase);
      const double along = still ? 0.0 : base + (is_driven(time) ? drive * std::cos(phase) : 0.0);
      if (watch.step(Vec3(now - before, 0.0, 0.0), Vec3(along, 0.0, 0.0), one_tick)) times.push_back(time);
      before = now;
    }
    return times;
  }
};

// Round trips begin where the hand passes its place against the force, here half a swing after it set out; the first
// passage that is seen ends one that is not whole and does not count.
TEST(RoundTripWatch, counts_whole_round_trips_alone_for_600_ms_and_three_of_them) {
  for (const double hertz : {3.1, 4.0, 5.5, 9.7, 17.0}) {
    const std::vector<double> times = SwingMotion{.hertz = hertz}.found();
    ASSERT_GT(times.size(), 1U) << hertz;
    const double trips = std::max(3.0, std::ceil(0.6 * hertz));
    EXPECT_NEAR(times[1] - times[0], trips / hertz, 0.003) << hertz << " Hz";
    // A slow hand has its place found first.
    if (hertz < 5.0) continue;
    EXPECT_NEAR(times[0], (1.5 + trips) / hertz, 0.003) << hertz << " Hz";
  }
}

TEST(RoundTripWatch, a_round_trip_that_is_not_driven_begins_the_count_again) {
  // Four of five at 10 Hz last 400 ms each time; two of three at 3.1 Hz 645 ms.
  for (const auto& [hertz, every] : {std::pair{10.0, 5.0}, {3.1, 3.0}}) {
    const auto is_driven = [hertz = hertz, every = every](double time) {
      return std::fmod(time * hertz + 0.5, every) < every - 1.0;
    };
    EXPECT_TRUE((SwingMotion{.hertz = hertz, .is_driven = is_driven}.found().empty())) << hertz << " Hz";
  }
}

TEST(RoundTripWatch, a_pause_without_force_begins_the_count_again) {
  const auto pauses = [](double length) {
    return SwingMotion{.rests = [length](double time) { return std::fmod(time, 0.45 + length) > 0.45; }}.found();
  };
  EXPECT_FALSE(pauses(0.1).empty()) << "as between two pulses";
  EXPECT_TRUE(pauses(0.15).empty());
}

TEST(RoundTripWatch, forces_too_small_to_shake_a_hand_do_not_count) {
  EXPECT_TRUE((SwingMotion{.base = 0.0, .drive = 0.09}.found().empty()));
  EXPECT_FALSE((SwingMotion{.base = 0.0, .drive = 0.3}.found().empty())) << "and turns to and fro with the swing";
}

TEST(RoundTripWatch, follows_a_hand_that_swings_elsewhere_afterwards) {
  const auto times =
      SwingMotion{.middle = [](double time) { return 20.0 * std::min(1.0, time); }, .seconds = 3.0}.found();
  EXPECT_FALSE(times.empty());
}

TEST(RoundTripWatch, tells_the_frequency_finer_than_the_ticks) {
  RoundTripWatch watch = watch_of_device();
  const double hertz = 61.3;
  const auto wave = [&](int tick) { return 0.5 * std::sin(2.0 * std::numbers::pi * hertz * one_tick * tick); };
  int seen = 0;
  for (int i = 1; i < 5000; ++i) {
    const double along = -3.0 + 0.3 * std::cos(2.0 * std::numbers::pi * hertz * one_tick * i);
    if (!watch.step(Vec3(wave(i) - wave(i - 1), 0.0, 0.0), Vec3(along, 0.0, 0.0), one_tick)) continue;
    ++seen;
    EXPECT_NEAR(watch.frequency(), hertz, 0.01 * hertz);
  }
  EXPECT_GT(seen, 3);
}

}  // namespace
}  // namespace bodkin
