// The governor's output, each force held over the next tick as by a motor, does no work on the hand: on many ways of
// every pair of a resistance and a constraint.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

#include "tests/sanitized.h"
#include "tests/simulation/needle_player.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {
namespace {

// The ways are short, so that there can be many of them. The possible work of a held force per tick grows with the
// square of the step, so most legs are fast; half of them stay near the needle's place, like a probing hand; slow
// ones are rare, because each takes as many ticks as ten others.
constexpr double quick = 60.0;       // mm/s and more
constexpr double slow_share = 0.05;  // of the legs, below that
constexpr double near = 4.0;         // mm

// So many ways find more than the few of AllModels. `pivot` stiffens with depth at no cost along the needle, as its
// paper has it (docs/models/pivot.md), and gives most: 2 N over a few millimetres.
constexpr double least_on_many_ways = -3.0;  // N mm

void walk(Player& player, Random& random) {
  player.reset();
  player.at(straight(-0.5));
  player.count_from_here();
  const double floor = random.uniform() < 0.3 ? in_bone : deepest;
  const int legs = 1 + static_cast<int>(random.uniform(0.0, 3.0));
  for (int leg = 0; leg < legs; ++leg) {
    const double speed = random.uniform() < slow_share ? random.uniform(5.0, quick) : random.uniform(quick, fastest);
    const double here = player.placement().tip.z();
    const bool probes = leg > 0 && random.uniform() < 0.5;
    Placement next =
        straight(probes ? std::clamp(here + random.uniform(-near, near), -0.5, floor) : random.uniform(-0.5, floor));
    next.tip.x() = random.uniform(-2.0, 2.0);
    next.tip.y() = random.uniform(-2.0, 2.0);
    next.tilt.x() = random.uniform(-0.05, 0.05);
    next.tilt.y() = random.uniform(-0.05, 0.05);
    player.go(next, speed);
    if (random.uniform() < 0.3) player.rest(static_cast<int>(random.uniform(1.0, 30.0)));
  }
  player.go(straight(-0.5), random.uniform(quick, fastest));
  player.rest(5);
}

int number_from(const char* name, int usual) {
  const char* const wanted = std::getenv(name);
  return wanted != nullptr ? std::max(1, std::atoi(wanted)) : usual;
}

class HeldForceCampaign : public testing::TestWithParam<NamedResistance> {};

// BODKIN_CAMPAIGN_WAYS ways of each pair, drawn from BODKIN_CAMPAIGN_SEED; a few without it.
TEST_P(HeldForceCampaign, gives_the_hand_no_work) {
  const NamedResistance& resistance = GetParam();
  const int usual = std::max(1, static_cast<int>((sanitized ? 2 : 60) * resistance.paths));
  const int ways = number_from("BODKIN_CAMPAIGN_WAYS", usual), seed = number_from("BODKIN_CAMPAIGN_SEED", 1);
  const bool told = std::getenv("BODKIN_CAMPAIGN_WAYS") != nullptr;
  for (const NamedConstraint& constraint : all_constraints()) {
    const Case body = patient_for(resistance, constraint);
    Player player(body);
    Random random(static_cast<std::uint64_t>(seed));
    const auto begin = std::chrono::steady_clock::now();
    double least = 0.0;
    long ticks = 0, giving = 0;
    for (int way = 0; way < ways; ++way) {
      walk(player, random);
      const double work = player.held() + player.given_by_springs();
      least = std::min(least, work);
      giving += work < -0.001 ? 1 : 0;
      ticks += player.ticks();
    }
    EXPECT_GE(least, least_on_many_ways) << constraint.name;
    const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (told)
      std::printf("| %s | %s | %d ways | %.1f million ticks | %ld gave work | %.3f N mm at most | %.1f s\n",
                  resistance.name.c_str(), constraint.name.c_str(), ways, static_cast<double>(ticks) * 1e-6, giving,
                  std::max(0.0, -least), taken);
  }
}

// A device's greatest force truncates along the force, even if two springs of unequal stiffness pull: that field no
// longer has a potential. A surface that is pressed by 20 mm beside a line that holds sideways shows it.
TEST(HeldForceLimit, two_springs_give_work_only_where_the_device_cuts_their_force_off) {
  const std::vector<NamedResistance> resistances = all_resistances();
  const std::vector<NamedConstraint> constraints = all_constraints();
  const auto proxy = std::ranges::find(resistances, "surface_proxy", &NamedResistance::name);
  const auto line = std::ranges::find(constraints, "line_spring", &NamedConstraint::name);
  ASSERT_TRUE(proxy != resistances.end() && line != constraints.end());
  for (const auto& [peak, least_expected, most_expected] :
       {std::tuple{6.0, least_on_many_ways, -0.5}, std::tuple{100.0, -0.001, 0.0}}) {
    Case body = patient_for(*proxy, *line);
    body.description.device.peak_force = peak;
    Player player(body);
    Random random(1);
    double least = 0.0;
    for (int way = 0; way < 1600; ++way) {
      walk(player, random);
      least = std::min(least, player.held() + player.given_by_springs());
    }
    EXPECT_GE(least, least_expected) << peak << " N";
    EXPECT_LE(least, most_expected) << peak << " N";
  }
}

INSTANTIATE_TEST_SUITE_P(Resistances, HeldForceCampaign, testing::ValuesIn(all_resistances()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace bodkin
