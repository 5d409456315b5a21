// Every resistance, constraint and device with 0 to 3 ms of delay, in hands and devices that know nothing of the
// guard. BODKIN_CAMPAIGN_TICKS=40000000 simulation_tests --gtest_filter='DelayedCampaign.*' is the long form, whose
// table is in docs/safety.md.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>

#include "tests/haptics/held_on_device.h"
#include "tests/sanitized.h"
#include "tests/simulation/delayed_rig.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::haptics;
namespace {

constexpr double created_bound = 2.0;  // N mm that a hand at rest may get in half a second

struct DelayedTally {
  int trials = 0, quiet = 0, restless = 0, calmed = 0, ended = 0;
  std::uint64_t ticks = 0;
  double largest_share = 0.0;  // of the device's peak
  double most_created = 0.0;   // N mm, truly, to a hand at rest in half a second
  double widest = 0.0;         // mm from side to side of a hand at rest
};

std::uint64_t wanted_delayed_ticks() {
  const char* text = std::getenv("BODKIN_CAMPAIGN_TICKS");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 0;
}

// In at 20 to 200 mm/s, sideways, a jerk, and rest. What a hand at rest does in the last half second is measured.
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
  const Vec3 given = rig.model.given;
  TurningPoints turns(0.03 + 2.0 * rig.abilities.resolution);
  double low = 1e9, high = -1e9;
  for (int i = 0; i < 500; ++i) {
    ASSERT_TRUE(step()) << what;
    turns.add(rig.depth());
    low = std::min(low, rig.depth());
    high = std::max(high, rig.depth());
  }
  const bool restless = turns.count() > 6;
  tally.restless += restless ? 1 : 0;
  tally.quiet += restless ? 0 : 1;
  tally.calmed += rig.count(GuardReason::calming) > 0 ? 1 : 0;
  tally.ended += rig.count(GuardReason::oscillation) > 0 ? 1 : 0;
  const double created = (rig.model.given - given).maxCoeff();
  tally.most_created = std::max(tally.most_created, restless || turns.count() == 0 ? created : 0.0);
  if (restless) {
    tally.widest = std::max(tally.widest, high - low);
    if (wanted_delayed_ticks() > 0) {
      std::printf("restless: %s: %d turns, %.3f mm, created %.3f N mm\n", what.c_str(), turns.count(), high - low,
                  created);
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
  std::map<std::string, DelayedTally> tallies;
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
    for (DelayedTally* tally : {&tallies[device.name], &sum}) {
      tally->trials += trial.trials;
      tally->quiet += trial.quiet;
      tally->restless += trial.restless;
      tally->calmed += trial.calmed;
      tally->ended += trial.ended;
      tally->ticks += trial.ticks;
      tally->largest_share = std::max(tally->largest_share, trial.largest_share);
      tally->most_created = std::max(tally->most_created, trial.most_created);
      tally->widest = std::max(tally->widest, trial.widest);
    }
  }
  if (wanted_delayed_ticks() > 0) {
    std::printf("%zu combinations refused of %zu\n", refused, trials);
    for (const auto& [name, tally] : tallies) {
      std::printf("| %s | %d | %.2f | %.3f | %d | %d | %d | %.3f | %.2f |\n", name.c_str(), tally.trials,
                  1e-6 * static_cast<double>(tally.ticks), tally.largest_share, tally.calmed, tally.ended,
                  tally.restless, tally.most_created, tally.widest);
    }
  }
  EXPECT_LT(refused, trials / 4);
  EXPECT_LE(sum.largest_share, 0.9 * (1.0 + 1e-9));
  EXPECT_LE(sum.restless, std::max(1, sum.trials / 100)) << "hands that were not quiet, see docs/safety.md";
  EXPECT_LE(sum.most_created, created_bound) << "N mm";
}

}  // namespace
}  // namespace bodkin
