// Every resistance, constraint and device with 0 to 3 ms of delay, in hands and devices independent of the guard.
// BODKIN_CAMPAIGN_TICKS=77000000 simulation_tests --gtest_filter='DelayedCampaign.*' is the long form, whose table is
// in docs/safety.md; BODKIN_CAMPAIGN_DEVICE=Touch runs one row of it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/haptics/held_on_device.h"
#include "tests/sanitized.h"
#include "tests/simulation/delayed_rig.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::haptics;
namespace {

constexpr double least_force = 0.05;   // N
constexpr double created_bound = 0.5;  // N mm that a hand at rest may get in half a second
constexpr double fading_bound = 20.0;  // N mm, the same of a hand whose swing dies away by itself

struct DelayedTally {
  int trials = 0, swung = 0, restless = 0, calmed = 0, ended = 0;
  std::uint64_t ticks = 0;
  double largest_share = 0.0;  // of the device's peak
  double most_created = 0.0;   // N mm, truly, to a hand at rest in half a second
  double most_fading = 0.0;    // N mm, the same to a hand whose swing dies away
  double widest = 0.0;         // mm from side to side of a hand at rest

  void add(const DelayedTally& other) {
    trials += other.trials;
    swung += other.swung;
    restless += other.restless;
    calmed += other.calmed;
    ended += other.ended;
    ticks += other.ticks;
    largest_share = std::max(largest_share, other.largest_share);
    most_created = std::max(most_created, other.most_created);
    most_fading = std::max(most_fading, other.most_fading);
    widest = std::max(widest, other.widest);
  }
};

std::uint64_t wanted_delayed_ticks() {
  const char* text = std::getenv("BODKIN_CAMPAIGN_TICKS");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 0;
}

bool is_wanted(const PublishedDevice& device) {
  const char* text = std::getenv("BODKIN_CAMPAIGN_DEVICE");
  return text == nullptr || device.name == std::string(text);
}

// A turning point of a hand at rest.
struct CycleMark {
  int tick = 0;
  double low = 0.0, high = 0.0;  // mm; the latter since the turning point before
  Vec3 given, place;             // N mm, mm
  Vec3 pushed;                   // N, summed over the ticks until then
};

// N mm created by whole cycles in half a second. The work of their mean force on the hand's drift comes from yielding
// tissue.
double created_in_cycles(const std::vector<CycleMark>& marks) {
  const CycleMark& first = marks.front();
  const CycleMark& last = marks[marks.size() - (marks.size() % 2 == 1 ? 1 : 2)];  // on the same side
  const double ticks = last.tick - first.tick;
  const Vec3 mean = (last.pushed - first.pushed) / ticks;
  const Vec3 created = last.given - first.given - mean.cwiseProduct(last.place - first.place);
  return 500.0 / ticks * created.maxCoeff();
}

// The motion of a hand at rest in half a second.
struct RestSeen {
  int turns = 0;
  double width = 0.0;      // mm from side to side
  double created = 0.0;    // N mm, truly; of a hand that swings within whole cycles
  double strongest = 0.0;  // N
  double kept = 0.0;       // of the first swing's width that the last one has

  // A decaying swing ends by itself, and a hand that swings on its arm after the force was removed is not shaken by
  // the device.
  bool continues() const { return turns > 6 && strongest > least_force && kept > 0.85; }
};

RestSeen rest_of(DelayedRig& rig) {
  RestSeen seen;
  TurningPoints turns(0.03 + 2.0 * rig.abilities.resolution);
  const Vec3 given = rig.model.given;
  std::vector<CycleMark> marks;
  Vec3 pushed = Vec3::Zero();
  double low = 1e9, high = -1e9;
  for (int i = 0; i < 500 && rig.is_safe(); ++i) {
    rig.tick();
    turns.add(rig.depth());
    pushed += rig.model.force();
    seen.strongest = std::max(seen.strongest, rig.model.force().norm());
    low = std::min(low, rig.depth());
    high = std::max(high, rig.depth());
    if (turns.count() > static_cast<int>(marks.size())) {
      marks.push_back({i, low, high, rig.model.given, rig.model.position, pushed});
      low = high = rig.depth();
    }
  }
  seen.turns = turns.count();
  for (const CycleMark& mark : marks) seen.width = std::max(seen.width, mark.high - mark.low);
  // The first and the last whole swings.
  if (marks.size() > 3) {
    seen.kept = (marks.back().high - marks.back().low) / (marks[1].high - marks[1].low);
  }
  seen.created =
      marks.size() < 3 ? (marks.empty() ? (rig.model.given - given).maxCoeff() : 0.0) : created_in_cycles(marks);
  return seen;
}

// In at 20 to 200 mm/s, sideways, a jerk, and two seconds of rest, after which it is judged; a hand that swings then
// is given three seconds more, and judged again.
void perform_trial(DelayedRig& rig, DelayedTally& tally, const std::string& what) {
  ++tally.trials;
  rig.arm();
  const double goal = rig.random.uniform(3.0, 50.0), speed = rig.random.uniform(20.0, 200.0);
  const double side = rig.random.uniform(-3.0, 3.0);
  const auto step = [&] {
    rig.tick();
    tally.largest_share = std::max(tally.largest_share, rig.applied.force.norm() / rig.abilities.peak_force);
    return rig.is_safe();
  };
  for (int i = 0; i < 1500; ++i) {
    rig.aim(std::min(goal, -5.0 + 0.001 * speed * i), side * std::min(1.0, 0.002 * i));
    ASSERT_TRUE(step()) << what;
  }
  rig.aim(goal + rig.random.uniform(-6.0, 6.0), -side);
  for (int i = 0; i < 2000; ++i) ASSERT_TRUE(step()) << what;
  RestSeen seen = rest_of(rig);
  ASSERT_TRUE(rig.is_safe()) << what;
  const bool swings = seen.continues();
  if (swings) {
    for (int i = 0; i < 3000; ++i) ASSERT_TRUE(step()) << what;
    seen = rest_of(rig);
    ASSERT_TRUE(rig.is_safe()) << what;
  }
  const bool restless = seen.continues();
  tally.swung += swings ? 1 : 0;
  tally.restless += restless ? 1 : 0;
  tally.calmed += rig.count(GuardReason::halved) > 0 ? 1 : 0;
  tally.ended += rig.count(GuardReason::oscillation) > 0 ? 1 : 0;
  double& most = restless || seen.turns == 0 ? tally.most_created : tally.most_fading;
  most = std::max(most, seen.created);
  if (restless) {
    tally.widest = std::max(tally.widest, seen.width);
    if (wanted_delayed_ticks() > 0) {
      std::printf("restless: %s: %d turns, %.3f mm, created %.3f N mm\n", what.c_str(), seen.turns, seen.width,
                  seen.created);
    }
  }
  tally.ticks += rig.ticks;
}

TEST(DelayedCampaign, late_forces_stay_within_their_limits_and_shake_no_hand_for_long) {
  const auto resistances = all_resistances();
  const auto constraints = all_constraints();
  const auto& devices = published_devices();
  constexpr double delays[] = {0.0, 0.001, 0.002, 0.003};
  constexpr std::size_t ticks_of_a_trial = 5500;
  const std::size_t all = devices.size() * resistances.size() * constraints.size() * std::size(delays) * 2;
  const std::size_t trials = sanitized ? 4 : std::max<std::size_t>(120, wanted_delayed_ticks() / ticks_of_a_trial);
  std::map<std::string, DelayedTally> tallies, by_knowledge;
  DelayedTally sum;
  std::size_t refused = 0;
  for (std::size_t n = 0; n < trials; ++n) {
    // A stride that is prime to the number of combinations visits every one of them before any twice.
    const std::size_t index = n * 7919 % all;
    std::size_t rest = index;
    const auto next = [&rest](std::size_t count) {
      const std::size_t chosen = rest % count;
      rest /= count;
      return chosen;
    };
    const PublishedDevice& device = devices[next(devices.size())];
    if (!is_wanted(device)) continue;
    const double delay = delays[next(std::size(delays))];
    const bool known = next(2) == 0;
    const NamedResistance& resistance = resistances[next(resistances.size())];
    const NamedConstraint& constraint = constraints[next(constraints.size())];
    const std::string what = std::string(device.name) + ", " + resistance.name + ", " + constraint.name + ", " +
                             std::to_string(static_cast<int>(1e3 * delay)) + " ms" + (known ? "" : ", not measured");
    std::unique_ptr<DelayedRig> rig;
    try {
      rig = std::make_unique<DelayedRig>(resistance, constraint, device, delay, known, 5000 + n);
    } catch (const InputError&) {
      ++refused;  // stiffer than the delay leaves: the case says so before any force
      continue;
    }
    DelayedTally trial;
    perform_trial(*rig, trial, what);
    if (testing::Test::HasFatalFailure()) return;
    for (DelayedTally* tally : {&tallies[device.name], &by_knowledge[known ? "measured" : "not measured"], &sum})
      tally->add(trial);
  }
  if (wanted_delayed_ticks() > 0) {
    std::printf("%zu combinations refused of %zu\n", refused, trials);
    tallies.merge(by_knowledge);
    for (const auto& [name, tally] : tallies) {
      std::printf("| %s | %d | %.2f | %.3f | %d | %d | %d | %d | %.3f | %.2f | %.2f |\n", name.c_str(), tally.trials,
                  1e-6 * static_cast<double>(tally.ticks), tally.largest_share, tally.calmed, tally.ended,
                  tally.swung, tally.restless, tally.most_created, tally.widest, tally.most_fading);
    }
  }
  EXPECT_LT(refused, trials / 4);
  EXPECT_LE(sum.largest_share, 0.9 * (1.0 + 1e-9));
  EXPECT_LE(sum.restless, std::max(1, sum.trials / 1000)) << "hands that were not quiet, see docs/safety.md";
  EXPECT_LE(sum.most_created, created_bound) << "N mm";
  EXPECT_LE(sum.most_fading, fading_bound) << "N mm";
}

// Needles that kept shaking a light hand at 25 Hz, and the wall that is active by design.
TEST(DelayedCampaign, an_embedded_needle_and_a_tracking_wall_on_an_omega_3_come_to_rest) {
  const PublishedDevice& omega = published_devices()[1];
  ASSERT_STREQ(omega.name, "omega.3");
  std::uint64_t seed = 900;
  for (const NamedResistance& resistance : all_resistances()) {
    const bool named = resistance.name == "embedded_needle" || resistance.name == "tracking_wall_strict" ||
                       resistance.name == "tracking_wall_rubbing";
    if (!named) continue;
    DelayedTally tally;
    for (const NamedConstraint& constraint : all_constraints()) {
      for (const bool known : {true, false}) {
        for (int hand = 0; hand < (sanitized ? 1 : 4); ++hand) {
          DelayedRig rig(resistance, constraint, omega, 0.003, known, ++seed);
          rig.model.mass = 0.05 + 0.05 * hand;  // light grips
          rig.model.grip_stiffness = 0.5;
          rig.model.arm_stiffness = 0.2;
          perform_trial(rig, tally, resistance.name + ", " + constraint.name + (known ? "" : ", not measured"));
          if (HasFatalFailure()) return;
        }
      }
    }
    EXPECT_EQ(tally.restless, 0) << resistance.name << ", widest " << tally.widest << " mm";
    EXPECT_LE(tally.most_created, created_bound) << resistance.name;
  }
}

}  // namespace
}  // namespace bodkin
