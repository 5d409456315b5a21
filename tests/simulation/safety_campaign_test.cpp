// Random and adversarial hands on every resistance, constraint and device, through a real device's whole chain.
// BODKIN_CAMPAIGN_TICKS=20000000 build/release/tests/simulation_tests --gtest_filter='SafetyCampaign.*' is the long
// form, whose numbers are in docs/safety.md.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

#include "tests/sanitized.h"
#include "tests/simulation/safety_rig.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::haptics;
using namespace bodkin::io;
namespace {

constexpr std::uint64_t short_ticks = sanitized ? 30'000 : 1'500'000;
constexpr double bone = 44.0;  // mm

std::uint64_t wanted_ticks() {
  const char* text = std::getenv("BODKIN_CAMPAIGN_TICKS");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : short_ticks;
}
bool is_long() {
  return std::getenv("BODKIN_CAMPAIGN_TICKS") != nullptr;
}

struct Tally {
  std::uint64_t ticks = 0, armed = 0;
  int trials = 0, holds = 0;
  int calmed_at_rest = 0;      // shaking without a hand that shakes, on models that are passive
  double largest_share = 0.0;  // of the device's peak
  double worst_growth = 0.0;   // mm by which a hand at rest swung more from one fifth of a second to the next, twice
  std::array<long, static_cast<std::size_t>(GuardReason::count_of_reasons)> counts{};
};

// How far a hand swings to and fro along any axis, mm: the smaller of its largest way up and its largest way down, so
// that creep is not a swing.
class Swing {
 public:
  void add(const Vec3& position) {
    low_ = low_.cwiseMin(position);
    high_ = high_.cwiseMax(position);
    up_ = up_.cwiseMax(position - low_);
    down_ = down_.cwiseMax(high_ - position);
  }
  double size() const { return up_.cwiseMin(down_).maxCoeff(); }

 private:
  Vec3 low_ = Vec3::Constant(1e9), high_ = Vec3::Constant(-1e9);
  Vec3 up_ = Vec3::Zero(), down_ = Vec3::Zero();
};

// One action of a hand, for a while. Returns false at the first unsafe tick.
bool misbehave(SafetyRig& rig, bool passive, Tally& tally) {
  Random& random = rig.random;
  const auto step = [&] {
    rig.tick();
    tally.armed += rig.state() == GuardState::disarmed || rig.state() == GuardState::faulted ? 0 : 1;
    tally.largest_share = std::max(tally.largest_share, rig.applied.force.norm() / rig.abilities.peak_force);
    return rig.is_safe();
  };
  const double here = rig.depth();
  const int kind = static_cast<int>(random.uniform(0.0, 8.0));
  const int ticks = kind == 7 ? 800 : 100 + static_cast<int>(random.uniform(0.0, 300.0));
  const double side = random.uniform(-3.0, 3.0);
  const double goal = random.uniform(-3.0, 52.0), speed = random.uniform(5.0, 250.0);
  const double frequency = random.uniform(1.0, 60.0), amplitude = random.uniform(0.1, 60.0 / frequency);
  const double grip = rig.hand.hand_stiffness;
  if (kind == 5) rig.hand.hand_stiffness = 0.0;  // lets go
  if (kind == 6) rig.hand.hand_stiffness = 2.0;  // clenches
  std::array<Swing, 4> quarters;
  int calmed = 0;
  for (int i = 0; i < ticks; ++i) {
    const double way = std::min(std::abs(goal - here), speed * 0.001 * i);
    const double travelled = here + (goal > here ? way : -way);
    if (kind <= 1) rig.aim(travelled, side * i / ticks, 0.0);
    if (kind == 2) rig.aim(here + amplitude * std::sin(6.283 * frequency * 0.001 * i), side);
    if (kind == 3 && i == 0) rig.aim(here + random.uniform(-15.0, 15.0), side, -side);  // jerks
    if (kind == 4) rig.aim(here + (i % 2 == 0 ? 0.5 : -0.5) * amplitude, 0.0, side);    // reverses at every tick
    if (kind == 7 && i == 0) rig.aim(std::min(here, bone + 6.0), side);                 // rests, is measured
    if (kind == 2) rig.tilt = 0.002 * side * std::sin(0.01 * i);
    if (!step()) return false;
    // The first quarter still contains the hand's previous motion.
    if (kind == 7 && i == ticks / 4) calmed = rig.count(GuardReason::halved) + rig.count(GuardReason::oscillation);
    if (kind == 7) quarters[static_cast<std::size_t>(4 * i / ticks)].add(rig.hand.position);
  }
  if (kind == 7) {
    ++tally.holds;
    if (passive) {
      tally.calmed_at_rest += rig.count(GuardReason::halved) + rig.count(GuardReason::oscillation) - calmed;
    }
    // From quarter to quarter: a membrane that gives way late in a hold makes the hand swing, but not more and more.
    const double growth = std::min(quarters[2].size() - quarters[1].size(), quarters[3].size() - quarters[2].size());
    tally.worst_growth = std::max(tally.worst_growth, growth);
  }
  rig.hand.hand_stiffness = grip;
  if (rig.state() == GuardState::disarmed || rig.state() == GuardState::faulted) {
    rig.tilt = 0.0;
    return rig.arm();
  }
  return true;
}

TEST(SafetyCampaign, no_hand_on_any_device_in_any_tissue_gets_more_than_the_device_may_give) {
  const auto devices = devices_with_force();
  const auto resistances = all_resistances();
  const auto constraints = all_constraints();
  const std::size_t combinations = devices.size() * resistances.size() * constraints.size();
  // The short form takes each pair with one device, another one for each; under a sanitizer a part of the pairs.
  const std::size_t stride = is_long() ? 1 : (sanitized ? 97 : devices.size() - 1);
  const std::uint64_t per_trial = wanted_ticks() * stride / combinations + 1;
  std::map<std::string, Tally> tallies;
  Tally all;
  for (std::size_t index = 0; index < combinations; index += stride) {
    const DeviceProfile& device = devices[index % devices.size()];
    const NamedResistance& resistance = resistances[index / devices.size() % resistances.size()];
    const NamedConstraint& constraint = constraints[index / devices.size() / resistances.size()];
    const std::string what = device.name + ", " + resistance.name + ", " + constraint.name;
    Tally& tally = tallies[device.name];
    const auto rig = std::make_unique<SafetyRig>(resistance, constraint, device, 1000 + index);
    ++tally.trials;
    ASSERT_TRUE(rig->arm()) << what;
    while (rig->ticks < per_trial) {
      ASSERT_TRUE(misbehave(*rig, !resistance.active, tally))
          << what << ", tick " << rig->ticks << ": " << rig->applied.force.transpose();
    }
    tally.ticks += rig->ticks;
    for (std::size_t i = 0; i < tally.counts.size(); ++i) tally.counts[i] += rig->counts[i];
    ASSERT_LT(tally.worst_growth, 0.1) << what << ": the hand swings more and more, mm";
  }
  for (const auto& entry : tallies) {
    const std::string& name = entry.first;
    const Tally& tally = entry.second;
    const auto count = [&tally](GuardReason reason) { return tally.counts[static_cast<std::size_t>(reason)]; };
    if (is_long()) {
      std::printf(
          "%s: trials %d, ticks %llu, armed %llu, largest share of peak %.4f, holds %d, worst growth "
          "%.4f "
          "mm, calmed at rest %d, calmed %ld, shaking %ld, too fast %ld, jump %ld, workspace %ld, thermal %ld, peak "
          "%ld\n",
          name.c_str(), tally.trials, static_cast<unsigned long long>(tally.ticks),
          static_cast<unsigned long long>(tally.armed), tally.largest_share, tally.holds, tally.worst_growth,
          tally.calmed_at_rest, count(GuardReason::halved), count(GuardReason::oscillation),
          count(GuardReason::too_fast), count(GuardReason::jump), count(GuardReason::workspace),
          count(GuardReason::thermal), count(GuardReason::peak));
    }
    all.ticks += tally.ticks;
    all.armed += tally.armed;
    all.trials += tally.trials;
    all.holds += tally.holds;
  }
  EXPECT_GE(all.ticks, wanted_ticks() / 2);
  EXPECT_GT(all.armed, all.ticks / 3) << "the hands felt something for a good part of it";
  EXPECT_GT(all.holds, 0);
}

// Turning points of a hand along the needle, each swing larger than what its encoder makes of rest.
class Turns {
 public:
  explicit Turns(double least) : least_(least) {}
  void add(double place) {
    extreme_ = forwards_ ? std::max(extreme_, place) : std::min(extreme_, place);
    if (std::abs(place - extreme_) < least_) return;
    forwards_ = !forwards_;
    extreme_ = place;
    ++count_;
  }
  int count() const { return count_; }

 private:
  double least_;
  double extreme_ = 0.0;
  bool forwards_ = true;
  int count_ = 0;
};

struct Leaning {
  int pairs = 0, on_bone = 0, calmed = 0, ended = 0;
  int most_turns = 0;         // in half a second, of models that are passive
  int most_active_turns = 0;  // of those that are documented not to be
};

// Two seconds after a hand has run into bone at 80 mm/s, half a second of leaning on it.
void lean_on_bone(const NamedResistance& resistance, const DeviceProfile& device, std::uint64_t seed, Leaning& all) {
  const std::string what = device.name + ", " + resistance.name;
  const auto rig = std::make_unique<SafetyRig>(resistance, all_constraints().front(), device, seed);
  ++all.pairs;
  ASSERT_TRUE(rig->arm(true)) << what;
  for (int i = 0; i < 700; ++i) {
    rig->aim(std::min(bone + 3.0, -5.0 + 0.08 * i));
    ASSERT_TRUE(rig->run(1)) << what;
  }
  Turns turns(0.02 + 2.0 * rig->abilities.resolution);
  // A tissue may give way late, and then the hand falls through it and swings. That has to die away; leaning is
  // measured when it has.
  for (int attempt = 0; attempt < 5; ++attempt) {
    ASSERT_TRUE(rig->run(1500)) << what;
    turns = Turns(0.02 + 2.0 * rig->abilities.resolution);
    const int given_way = rig->given_way;
    for (int i = 0; i < 500; ++i) {
      ASSERT_TRUE(rig->run(1)) << what;
      turns.add(rig->depth());
    }
    if (rig->given_way == given_way) break;
  }
  all.on_bone += rig->depth() > bone && rig->applied.force.norm() > 0.1 ? 1 : 0;
  all.calmed += rig->count(GuardReason::halved);
  all.ended += rig->state() == GuardState::faulted ? 1 : 0;
  if (resistance.active) {  // documented to give energy: its forces are bounded, its motion is not quiet
    all.most_active_turns = std::max(all.most_active_turns, turns.count());
    return;
  }
  all.most_turns = std::max(all.most_turns, turns.count());
  // Creep and occasional punctures are not shaking, which would be 30 turns and more.
  EXPECT_LE(turns.count(), 6) << what;
  EXPECT_EQ(rig->count(GuardReason::halved), 0) << what;
  EXPECT_EQ(rig->state(), GuardState::active) << what << ": " << text_of(rig->servo->snapshot().fault);
}

// At the device's own stiffness, with its encoder, its delay and no more damping than its stiffness needs.
TEST(SafetyCampaign, a_hand_that_leans_on_bone_does_not_shake) {
  Leaning all;
  std::size_t index = 0;
  for (const DeviceProfile& device : devices_with_force()) {
    for (const NamedResistance& resistance : all_resistances()) {
      if (sanitized && index++ % 17 != 0) continue;
      for (std::uint64_t seed = 1; seed <= (is_long() ? 10U : 2U); ++seed)
        lean_on_bone(resistance, device, seed, all);
    }
  }
  EXPECT_GT(all.on_bone, 3);
  if (is_long()) {
    std::printf("bone: %d hands, %d on bone at the end, most turns %d (active %d), calmed %d, ended %d\n", all.pairs,
                all.on_bone, all.most_turns, all.most_active_turns, all.calmed, all.ended);
  }
}

// A wall of `stiffness` (N/mm) from the skin on.
void put_wall(SafetyRig& rig, double stiffness) {
  rig.controller = [stiffness](const ControlInput& input) {
    return Control{{Vec3(0.0, 0.0, -stiffness * std::max(0.0, input.needle.translation().z())), Vec3::Zero()}, 0.0};
  };
}

double stiffness_of(const SafetyRig& rig) {
  return rig.abilities.stiffness > 0.0 ? rig.abilities.stiffness : 1.0;
}

// A positive control of the campaign: walls far too stiff for their device shake the hand, until the guard halves or
// ends the force.
TEST(SafetyCampaign, a_wall_that_the_device_cannot_render_is_calmed_or_ended) {
  int shaken = 0, ended = 0;
  for (const DeviceProfile& device : devices_with_force()) {
    for (const double factor : {5.0, 10.0, 40.0}) {
      SafetyRig rig(all_resistances().front(), all_constraints().front(), device, 3);
      const std::string what = device.name + ", " + std::to_string(factor);
      put_wall(rig, factor * stiffness_of(rig));
      ASSERT_TRUE(rig.arm(true)) << what;
      rig.hand.hand_stiffness = 0.5;
      for (int i = 0; i < 3000; ++i) {
        rig.aim(std::min(2.0, -5.0 + 0.03 * i));
        ASSERT_TRUE(rig.run(1)) << what;
      }
      Turns turns(0.02 + 2.0 * rig.abilities.resolution);
      for (int i = 0; i < 500; ++i) {
        ASSERT_TRUE(rig.run(1)) << what;
        turns.add(rig.depth());
      }
      EXPECT_LE(turns.count(), 6) << what << ": it is quiet now";
      shaken += rig.count(GuardReason::halved);
      ended += rig.servo->snapshot().fault == GuardReason::oscillation ? 1 : 0;
    }
  }
  EXPECT_GT(shaken, 10);
  EXPECT_GT(ended, 5);
  if (is_long()) std::printf("walls too stiff: %d calmed, %d of them ended\n", shaken, ended);
}

// On a wall of `stiffness` (N/mm).
void expect_a_trembling_hand_keeps_its_force(const DeviceProfile& device, double stiffness, std::uint64_t seed) {
  SafetyRig rig(all_resistances().front(), all_constraints().front(), device, seed);
  put_wall(rig, stiffness);
  ASSERT_TRUE(rig.arm(true)) << device.name;
  rig.hand.hand_stiffness = 2.0;
  const std::pair<double, double> shakes[] = {{4.0, 3.0},  {6.0, 3.0},  {8.0, 2.0},
                                              {11.0, 1.0}, {14.0, 0.3}, {18.0, 0.3}};
  for (const auto& [hertz, wide] : shakes) {
    for (int i = 0; i < 1000; ++i) {
      rig.aim(1.0 + wide * std::sin(6.283 * hertz * 0.001 * i));
      ASSERT_TRUE(rig.run(1)) << device.name;
    }
    EXPECT_EQ(rig.count(GuardReason::halved), 0) << device.name << ", " << hertz << " Hz, seed " << seed;
  }
  EXPECT_EQ(rig.state(), GuardState::active) << device.name;
}

// A person may shake, as fast as a person can, on the stiffest wall that the device renders.
TEST(SafetyCampaign, a_hand_that_shakes_by_itself_keeps_its_force) {
  for (const DeviceProfile& device : devices_with_force()) {
    const double known = device.of(DeviceQuantity::stiffness).value;
    expect_a_trembling_hand_keeps_its_force(device, known > 0.0 ? known : 1.0, 3);
  }
}

// Its encoder of 0.055 mm makes single cycles of 18 Hz look like 19 Hz.
TEST(SafetyCampaign, a_hand_that_shakes_by_itself_on_a_touch_keeps_its_force) {
  const auto devices = devices_with_force();
  DeviceProfile touch = *find_profile(devices, "Touch");
  touch.values[static_cast<std::size_t>(DeviceQuantity::stiffness)].value = 0.4;  // CHAI3D's number
  for (std::uint64_t seed = 1; seed <= (sanitized ? 2U : 10U); ++seed)
    expect_a_trembling_hand_keeps_its_force(touch, 0.4, seed);
}

}  // namespace
}  // namespace bodkin
