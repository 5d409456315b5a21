// HandGuard's response to a shaken hand: half the force, a quarter and damping, none, for any detector.
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "tests/haptics/guard_rig.h"
#include "tests/haptics/uneven_swing.h"
#include "tests/training/page_table.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "haptics/swing_watch.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

const Vec3 no_push = Vec3::Zero();

double wave(double hertz, double time) {
  return std::sin(2.0 * std::numbers::pi * hertz * time);
}
double quarter_earlier(double hertz, double time) {
  return std::cos(2.0 * std::numbers::pi * hertz * time);
}

// When each step was taken, s; 0: never within eight seconds.
struct Steps {
  double softer = 0.0, damped = 0.0, ended = 0.0, zero = 0.0;
};

// A hand that moves by `hand`, regardless of the force, under the force `wanted`; both functions of time, s.
Steps shake_on(GuardRig& rig, const std::function<Pose(double)>& hand, const std::function<Wrench(double)>& wanted) {
  rig.push(no_push);
  for (int i = 0; i < 100; ++i) rig.tick(wanted(0.0));
  const Vec3 start = rig.device.hand.translation();
  Steps seen;
  for (int i = 0; i < 8000 && seen.zero == 0.0; ++i) {
    const double time = 0.001 * i;
    rig.device.hand = hand(time);
    rig.device.hand.translation() += start;
    const Wrench& applied = rig.tick(wanted(time));
    if (seen.softer == 0.0 && rig.count(GuardReason::halved) > 0) seen.softer = time;
    if (seen.damped == 0.0 && rig.count(GuardReason::damping) > 0) seen.damped = time;
    if (seen.ended == 0.0 && rig.count(GuardReason::oscillation) > 0) seen.ended = time;
    if ((seen.softer > 0.0 || !rig.guard.is_armed()) && applied.force.isZero(0.0) && applied.torque.isZero(0.0))
      seen.zero = time;
  }
  return seen;
}

// Half, a quarter with damping, none, each of them an event, the last `within` s of the first.
void expect_all_steps(const GuardRig& rig, const Steps& seen, const std::string& what, double within = 0.1) {
  EXPECT_GT(seen.softer, 0.0) << what << ": it was not found";
  EXPECT_GT(seen.damped, seen.softer) << what;
  EXPECT_GT(seen.zero, seen.damped) << what;
  EXPECT_LE(seen.zero - seen.softer, within + 1e-4) << what;
  EXPECT_LE(seen.zero - seen.ended, 0.0201) << what;
  EXPECT_EQ(rig.count(GuardReason::halved), 1) << what;
  EXPECT_EQ(rig.count(GuardReason::damping), 1) << what;
  EXPECT_EQ(rig.count(GuardReason::oscillation), 1) << what;
  EXPECT_EQ(rig.guard.fault(), GuardReason::oscillation) << what;
}

std::string on_axis(int axis, double hertz) {
  return "axis " + std::to_string(axis) + ", " + std::to_string(hertz) + " Hz";
}

// A force independent of the hand's place exchanges energy that no tissue stored: passivity would damp it.
GuardSettings undamped() {
  GuardSettings settings = GuardRig::example();
  settings.damping = 0.0;
  return settings;
}

std::function<Pose(double)> turning(int axis, double hertz, double amplitude) {
  return [=](double time) { return Pose(Eigen::AngleAxisd(amplitude * wave(hertz, time), Vec3::Unit(axis))); };
}
// `share` of the torque swings with the tool.
std::function<Wrench(double)> torque_of(double hertz, double share) {
  return [=](double time) { return Wrench{no_push, Vec3(0.0, 0.0, 80.0 * (1.0 - share * wave(hertz, time)))}; };
}
std::function<Pose(double)> moving(int axis, std::function<double(double)> place) {
  return [axis, place = std::move(place)](double time) {
    return Pose(Eigen::Translation3d(place(time) * Vec3::Unit(axis)));
  };
}

TEST(HandGuardShaking, a_tool_that_turns_to_and_fro_about_any_axis_loses_its_torque_step_by_step) {
  for (int axis = 0; axis < 3; ++axis) {
    // From 0.02 rad on at 19 Hz; below, from 20 m/s^2 at 30 mm.
    for (const double hertz : {6.0, 8.0, 12.0, 18.0, 20.0, 30.0, 60.0, 100.0, 150.0, 200.0}) {
      GuardRig rig;
      const double amplitude =
          hertz > 19.0 ? 0.02 : 750.0 / (2.0 * std::numbers::pi * hertz * 2.0 * std::numbers::pi * hertz);
      const Steps seen = shake_on(rig, turning(axis, hertz, amplitude), torque_of(hertz, 0.0));
      expect_all_steps(rig, seen, on_axis(axis, hertz));
      EXPECT_LE(seen.softer, 4.0 / hertz + 0.001) << on_axis(axis, hertz);
    }
    for (const double hertz : {3.0, 4.0, 8.0, 12.0, 18.0}) {  // small and even, while the torque swings along
      GuardRig rig;
      const Steps seen = shake_on(rig, turning(axis, hertz, 0.02), torque_of(hertz, 0.2));
      expect_all_steps(rig, seen, on_axis(axis, hertz));
      EXPECT_LE(seen.softer, hertz < 8.5 ? 13.75 / hertz : 1.2 + 3.0 / hertz) << on_axis(axis, hertz);
    }
  }
}

TEST(HandGuardShaking, a_tool_that_turns_as_a_hand_turns_it_keeps_its_torque) {
  GuardRig rig;
  EXPECT_EQ(shake_on(rig, turning(0, 12.0, 0.02), torque_of(12.0, 0.0)).softer, 0.0);
  EXPECT_EQ(rig.guard.state(), GuardState::active);
}

TEST(HandGuardShaking, what_turns_is_damped_about_the_axis_on_which_it_turns) {
  GuardRig rig, without(undamped());
  double worked = 0.0, sideways = 0.0;
  int damped = 0;
  for (GuardRig* one : {&rig, &without}) {
    const auto hand = turning(0, 12.0, 0.15);
    const auto torque = torque_of(12.0, 0.0);
    one->push(no_push);
    for (int i = 0; i < 600 && one->guard.is_armed(); ++i) {
      const double time = 0.001 * i;
      one->device.hand = hand(time);
      const Wrench& applied = one->tick(torque(time));
      if (one->count(GuardReason::damping) == 0 || !one->guard.is_armed()) continue;
      sideways = std::max(sideways, std::abs(applied.torque.y()));
      if (one == &without) {
        EXPECT_EQ(applied.torque.x(), 0.0);
        continue;
      }
      ++damped;
      worked += applied.torque.x() * 0.15 * 2.0 * std::numbers::pi * 12.0 * quarter_earlier(12.0, time) * 0.001;
      EXPECT_NEAR(applied.torque.z(), 20.0, 1e-9) << "a quarter";
    }
  }
  EXPECT_GE(damped, 25) << "ms of that step";
  EXPECT_LT(worked, -0.1) << "N mm that the hand gave away";
  EXPECT_EQ(sideways, 0.0);
}

// Only the account of energy finds it: each cycle is wider or narrower than the one before, and none is wide or fast.
TEST(HandGuardShaking, what_the_force_drives_goes_through_the_same_steps) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double hertz : {3.2, 4.0, 6.0, 8.0, 11.0, 14.0, 18.0}) {
      GuardRig rig(undamped());
      const auto place = [hertz](double time) {
        return (std::fmod(time * hertz, 2.0) < 1.0 ? 0.5 : 0.85) * wave(hertz, time);
      };
      const auto force = [axis, hertz](double time) {
        return Wrench{3.0 * (1.0 + 0.3 * quarter_earlier(hertz, time)) * Vec3::Unit(axis), no_push};
      };
      const Steps seen = shake_on(rig, moving(axis, place), force);
      expect_all_steps(rig, seen, on_axis(axis, hertz));
      EXPECT_LE(seen.softer, (hertz > 10.0 ? 0.25 : 0.6) + 1.75 / hertz) << on_axis(axis, hertz);
    }
  }
}

// A driven hand that swings unevenly: a spring of 1 N/mm about a push of 3 N answers 3 ms late.
class DrivenHand {
 public:
  DrivenHand(double hertz, std::uint64_t seed) : places_(4, 0.0) {
    UnevenSwing hand(hertz, 1.0, 0.3, seed);
    for (int i = 0; i < 8000; ++i) places_.push_back(hand.step(0.001));
  }
  Steps steps(GuardRig& rig, int axis) const {
    return shake_on(rig, moving(axis, [this](double time) { return place(time, 0); }), [&](double time) {
      return Wrench{(3.0 - place(time, 3)) * Vec3::Unit(axis), no_push};
    });
  }

 private:
  double place(double time, int late) const {
    return places_[static_cast<std::size_t>(std::lround(1000.0 * time) + 4 - late)];
  }

  std::vector<double> places_;  // mm, one each ms
};
GuardSettings undamped_of_1_N_mm() {
  GuardSettings settings = undamped();
  settings.stiffness = 1.0;
  return settings;
}

// Neither even nor wide, and the energy from turn to turn is hidden by what the spring stores: a late spring drives
// it.
TEST(HandGuardShaking, what_is_driven_unevenly_goes_through_the_same_steps) {
  int late = 0;  // found later than usual, due to their uneven swings
  for (int seed = 1; seed <= 300; ++seed) {
    const int axis = (seed - 1) % 3;
    for (const double hertz : {3.5, 5.0, 8.0, 12.0}) {
      GuardRig rig(undamped_of_1_N_mm());
      const Steps seen = DrivenHand(hertz, static_cast<std::uint64_t>(seed)).steps(rig, axis);
      expect_all_steps(rig, seen, on_axis(axis, hertz) + ", hand " + std::to_string(seed));
      const double usual = 1.0 + 6.0 / hertz;
      if (seed <= 3) {
        EXPECT_LE(seen.softer, usual) << on_axis(axis, hertz);
      }
      late += seen.softer > usual ? 1 : 0;
    }
  }
  EXPECT_LE(late, 24) << "of 1200";
}

// The hand swings evenly, regardless of the force. The force of 3 N opposes its speed by a tenth of itself, so that
// the hand gives energy with each cycle and no account finds anything amiss.
TEST(HandGuardShaking, a_slow_small_even_swing_ends_the_force_though_the_hand_does_the_work) {
  for (const double wide : {0.2, 1.5, 5.0}) {
    for (const double hertz : {3.0, 4.0, 5.0, 6.0, 7.0, 8.4, 9.0, 12.0, 18.0}) {
      if (wide > 1.5 && hertz > 8.0) continue;  // wide enough to be found at once
      GuardRig rig(undamped());
      const auto force = [hertz](double time) {
        return Wrench{Vec3(0.0, 0.0, 3.0 * (1.0 - 0.1 * quarter_earlier(hertz, time))), no_push};
      };
      const Steps seen = shake_on(rig, moving(2, [=](double time) { return wide * wave(hertz, time); }), force);
      expect_all_steps(rig, seen, on_axis(2, hertz));
      EXPECT_LE(seen.softer, hertz < 8.5 ? 13.75 / hertz : 1.2 + 3.0 / hertz) << on_axis(2, hertz);
      EXPECT_GE(rig.guard.energy().z(), 0.0) << "the hand has given it";
    }
  }
}

// From the onset to zero force, the longest of eight beginnings: the table of docs/safety.md.
TEST(HandGuardShaking, the_table_of_times_is_as_measured) {
  const auto longest = [](const std::function<Steps(int)>& begun) {
    double time = 0.0;
    for (int beginning = 0; beginning < 8; ++beginning) {
      const Steps seen = begun(beginning);
      EXPECT_GT(seen.zero, 0.0);
      time = std::max(time, seen.zero);
    }
    return fmt::format(" {:.2f} |", time);
  };
  std::string heading = "| frequency, Hz |", line = "|---|";
  std::string wide = "| wide or fast: s |", even = "| small and even: s |", driven = "| driven unevenly: s |";
  for (const double hertz : {3.0, 5.0, 8.4, 10.0, 18.0, 20.0, 50.0, 200.0}) {
    heading += fmt::format(" {:g} |", hertz);
    line += "---|";
    const double quick = 0.75 * SwingWatch(GuardSettings().oscillation_amplitude).allowed(hertz);
    const auto begun_at = [&](double size, double share, int beginning) {
      GuardRig rig(undamped());
      const double phase = 0.125 * beginning;
      const auto force = [=](double time) {
        return Wrench{Vec3(0.0, 0.0, 3.0 * (1.0 - share * quarter_earlier(hertz, time))), no_push};
      };
      return shake_on(rig,
                      moving(2,
                             [=](double time) {
                               return size * (wave(hertz, time + phase / hertz) - wave(hertz, phase / hertz));
                             }),
                      force);
    };
    wide += longest([&](int beginning) { return begun_at(quick, 0.0, beginning); });
    if (hertz > 19.0) {
      even += " |";
      driven += " |";
      continue;
    }
    even += longest([&](int beginning) { return begun_at(0.2, 0.1, beginning); });
    driven += longest([&](int beginning) {
      GuardRig rig(undamped_of_1_N_mm());
      // A swing faster than 3 Hz on average is slower at times.
      return DrivenHand(std::max(hertz, 3.5), static_cast<std::uint64_t>(beginning + 1)).steps(rig, 2);
    });
  }
  const std::string table = heading + "\n" + line + "\n" + wide + "\n" + even + "\n" + driven + "\n";
  training::expect_table_on_page("safety.md", "| frequency, Hz |", table, 0.02);
}

TEST(HandGuardShaking, a_slow_small_swing_under_a_steady_force_is_the_hands_own) {
  for (const double hertz : {3.0, 5.0, 8.0}) {
    GuardRig rig(undamped());
    const auto force = [](double) { return Wrench{Vec3(0.0, 0.0, 3.0), no_push}; };
    const Steps seen = shake_on(rig, moving(2, [hertz](double time) { return 1.5 * wave(hertz, time); }), force);
    EXPECT_EQ(seen.softer, 0.0) << hertz << " Hz";
  }
}

// Moves the hand to and fro along the force.
void shake(GuardRig& rig, double hertz, double amplitude, double seconds) {
  const Vec3 start = rig.device.hand.translation();
  for (int i = 0; i < static_cast<int>(1000.0 * seconds); ++i) {
    rig.device.hand.translation() = start + Vec3(0.0, 0.0, amplitude * wave(hertz, 0.001 * i));
    rig.tick(Vec3(0.0, 0.0, 3.0));
  }
  rig.device.hand.translation() = start;
}

TEST(HandGuardShaking, a_shaking_hand_gets_half_the_force_and_then_none) {
  GuardRig rig(undamped());
  rig.push({0.0, 0.0, 3.0});
  shake(rig, 45.0, 0.3, 0.09);
  EXPECT_NEAR(rig.guard.applied().force.z(), 1.5, 1e-9);
  EXPECT_EQ(rig.count(GuardReason::halved), 1);
  shake(rig, 45.0, 0.3, 0.1);
  EXPECT_EQ(rig.guard.fault(), GuardReason::oscillation);
  EXPECT_TRUE(rig.guard.applied().force.isZero(0.0));
}

TEST(HandGuardShaking, half_the_force_becomes_the_whole_again_when_the_hand_was_quiet_for_ten_seconds) {
  GuardRig rig(undamped());
  rig.push({0.0, 0.0, 3.0});
  for (int i = 0; i < 200 && rig.count(GuardReason::halved) == 0; ++i) {
    rig.device.hand.translation().z() = 0.3 * wave(60.0, 0.001 * i);
    rig.tick(Vec3(0.0, 0.0, 3.0));
  }
  EXPECT_NEAR(rig.guard.applied().force.z(), 1.5, 1e-9);
  for (int i = 0; i < 9500; ++i) rig.tick(Vec3(0.0, 0.0, 3.0));
  EXPECT_NEAR(rig.guard.applied().force.z(), 1.5, 1e-9);
  for (int i = 0; i < 2000; ++i) rig.tick(Vec3(0.0, 0.0, 3.0));
  EXPECT_NEAR(rig.guard.applied().force.z(), 3.0, 0.1);
}

TEST(HandGuardShaking, tremor_and_encoder_noise_are_no_shaking) {
  GuardSettings settings = undamped();
  settings.oscillation_amplitude = 1.9 * 0.055;
  GuardRig tremor(settings);
  tremor.push({0.0, 0.0, 3.0});
  shake(tremor, 12.0, 1.0, 3.0);
  EXPECT_EQ(tremor.guard.state(), GuardState::active);

  GuardRig noise(settings);
  noise.push({0.0, 0.0, 3.0});
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    noise.device.hand.translation().z() = random.uniform() < 0.5 ? 0.0 : 0.055;
    noise.tick(Vec3(0.0, 0.0, 3.0));
  }
  EXPECT_EQ(noise.guard.state(), GuardState::active);
  EXPECT_TRUE(tremor.events.empty() && noise.events.empty());
}

}  // namespace
}  // namespace bodkin
