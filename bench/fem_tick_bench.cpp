// The cost of a needle in a deformable body with k contact points. The motion is prerecorded and the state is warm.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "bench/tick_times.h"
#include "tests/fem/dense_body.h"
#include <benchmark/benchmark.h>

#include "fem/contact_factor.h"
#include "fem/display_field.h"
#include "fem/embedded_needle.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::fem;

const CondensedBody& thousand_nodes() {
  static const CondensedBody body = checks::kelvin_body(5, 40, 2.0);
  return body;
}

// Only the factor: a solve every tick; every 20 ticks a node comes or goes at the end, as at a needle's tip, or
// (second argument 1) one leaves from anywhere.
void factor_tick(benchmark::State& state) {
  const auto nodes = static_cast<std::size_t>(state.range(0));
  const bool anywhere = state.range(1) != 0;
  ContactFactor factor(thousand_nodes().compliance, 170);
  Random random(1);
  const auto grow = [&] {
    while (
        !factor.append(static_cast<std::uint32_t>(random.next() % thousand_nodes().nodes.size()), Mat3::Identity())) {
    }
  };
  while (factor.constraints() < nodes) grow();
  std::vector<double> values(3 * 170);
  bool more = true;
  time_every_tick(state, 0, [&](int tick) {
    if (tick % 20 == 0) {
      if (more) {
        grow();
      } else if (anywhere) {
        factor.remove(random.next() % factor.constraints());
      } else {
        factor.remove_last();
      }
      more = factor.constraints() <= nodes;
    }
    for (std::size_t i = 0; i < factor.rows(); ++i)
      values[i] = std::sin(0.001 * tick) + 0.01 * static_cast<double>(i);
    factor.solve(values);
    benchmark::DoNotOptimize(values.data());
  });
}

BENCHMARK(factor_tick)->ArgNames({"k", "anywhere"})->ArgsProduct({{1, 10, 50, 150}, {0, 1}})->Iterations(50000);

// A point every 0.5 mm of the needle's way, 85 mm of soft tissue.
const CondensedBody& way_of_the_needle() {
  static const CondensedBody body = [] {
    CondensedBody made;
    for (int i = 0; i < 170; ++i) {
      made.nodes.emplace_back(0.0, 0.0, 0.5 * i);
      made.tissues.push_back(tissue::soft);
    }
    checks::fill_compliance(made, 0.05, 0.3);
    return checks::as_points(std::move(made));
  }();
  return body;
}

EmbeddedNeedle needle_on_its_way(const CondensedBody& body, bool bends, const Eigen::MatrixXd* other = nullptr,
                                 const NeedleRelaxation& relaxation = {}) {
  ContactTissues tissues;
  tissues.fill({.friction = 0.005});
  EmbeddedNeedleSettings settings;
  settings.capture_radius = 0.6;
  settings.most_nodes = 160;
  std::optional<NeedleBeam> beam;
  if (bends) beam = NeedleBeam({.rigidity = 257.0, .length = 90.0, .cut_offset = 0.1});
  EmbeddedNeedle needle(body, tissues, settings, 1e-3, beam, other, relaxation);
  needle.begin(Vec3::Zero(), Vec3::UnitZ());
  return needle;
}

// How the hand moves: at 25 mm/s; unsteadily, which sways by 3 mm at 2 Hz and trembles by 0.2 mm at 10 Hz along the
// needle; at 125 mm/s, 4 ticks a node; at 500 mm/s, a node a tick.
enum class Hand { steady, unsteady, fast, fastest };

// Pushed and drawn by 5 mm about `depth`, swaying: 2000 ticks.
std::vector<Pose> pushing_and_swaying(double depth, Hand hand = Hand::steady) {
  const bool unsteady = hand == Hand::unsteady;
  const int faster = hand == Hand::fast ? 5 : hand == Hand::fastest ? 20 : 1;
  std::vector<Pose> motion;
  for (int i = 0; i < 2000; ++i) {
    const int tick = i * faster % 2000;
    const double swing = std::abs(static_cast<double>(tick % 400) - 200.0) / 200.0;  // 1 to 0 to 1
    const double turn = 2.0 * 3.14159265358979323846, angle = turn * tick / 2000.0;
    const double sway = unsteady ? 3.0 * std::sin(turn * 0.002 * i) : 0.0;
    const double tremor = unsteady ? 0.2 * std::sin(turn * 0.010 * i) : 0.0;
    motion.push_back(needle_pose(
        Vec3(sway + 0.5 * std::sin(angle), 0.3 * std::sin(2.0 * angle), tremor + depth - 2.5 + 5.0 * swing),
        Vec3(0.01 * std::sin(3.0 * angle), 0.0, 1.0)));
  }
  return motion;
}

// A needle that holds k nodes and is pushed and drawn by 5 mm at 25 mm/s, a node every 20 ticks, while it sways:
// nodes come and go, friction slides, and turns round every 200 ticks. Second argument 1: it bends (27G, clamped,
// with a bevel). Third argument: the hand.
void time_needle(benchmark::State& state, EmbeddedNeedle contact, Hand hand) {
  const double depth = 0.5 * static_cast<double>(state.range(0)) - 0.25;
  const std::vector<Pose> motion = pushing_and_swaying(depth, hand);
  for (double tip = -1.0; tip < depth + 2.5; tip += 0.02)
    contact.step(needle_pose(Vec3(0.0, 0.0, tip), Vec3::UnitZ()));
  double nodes = 0.0, sticking = 0.0;
  std::int64_t ticks = 0;
  time_every_tick(state, motion.size(), [&](int tick) {
    const EmbeddedNeedleForce& force = contact.step(motion[static_cast<std::size_t>(tick) % motion.size()]);
    nodes += force.nodes;
    sticking += force.sticking;
    ++ticks;
  });
  state.counters["nodes"] = nodes / static_cast<double>(ticks);
  state.counters["sticking"] = sticking / static_cast<double>(ticks);
}

void needle_tick(benchmark::State& state) {
  time_needle(state, needle_on_its_way(way_of_the_needle(), state.range(1) != 0), static_cast<Hand>(state.range(2)));
}

// In relaxing tissue, with two terms.
void relaxing_tick(benchmark::State& state) {
  const std::vector<PronyTerm> terms = {{.share = 0.3, .time = 0.1}, {.share = 0.2, .time = 2.0}};
  time_needle(state, needle_on_its_way(way_of_the_needle(), false, nullptr, {terms}), Hand::steady);
}

// The slowest tick during the exchange of the compliance of k points, because other nodes are held.
void changeover_tick(benchmark::State& state) {
  const CondensedBody& body = way_of_the_needle();
  const Eigen::MatrixXd stiffer = 0.8 * body.compliance;
  EmbeddedNeedle contact = needle_on_its_way(body, false, &stiffer);
  const double depth = 0.5 * static_cast<double>(state.range(0)) - 0.25;
  for (double tip = -1.0; tip < depth; tip += 0.02) contact.step(needle_pose(Vec3(0.0, 0.0, tip), Vec3::UnitZ()));
  const Pose rest = needle_pose(Vec3(0.0, 0.0, depth), Vec3::UnitZ());
  std::vector<double> slowest;
  for (auto _ : state) {
    double most = 0.0;
    contact.exchange();
    while (contact.exchanges()) {
      const double start = processor_time();
      contact.step(rest);
      most = std::max(most, processor_time() - start);
    }
    if (!contact.exchanged()) state.SkipWithError("the equations were singular");
    slowest.push_back(most);
  }
  report_times(state, std::move(slowest));
}

// The displacement field for the display: a grid of 32^3 points and 2116 points of skin.
void display_field(benchmark::State& state) {
  constexpr Eigen::Index points = 32 * 32 * 32 + 2116;
  static const DisplayField field = [] {
    Eigen::MatrixXf columns(3 * points, 3 * 400);  // 400 nodes
    std::uint64_t number = 0;
    for (float& value : columns.reshaped()) value = static_cast<float>(mix64(++number) % 1000) * 1e-3F;
    return DisplayField(std::move(columns));
  }();
  NodeForces forces;
  forces.count = static_cast<std::size_t>(state.range(0));
  std::vector<float> moved(3 * points);
  time_every_tick(state, 0, [&](int tick) {
    for (std::size_t i = 0; i < forces.count; ++i) {
      forces.nodes[i] = {static_cast<std::uint32_t>((i * 7 + static_cast<std::size_t>(tick) / 4) % 400),
                         {0.1F, 0.2F, 0.3F}};
    }
    field.evaluate(forces, moved);
    benchmark::DoNotOptimize(moved.data());
  });
}

BENCHMARK(machine_itself)->Iterations(50000);
BENCHMARK(needle_tick)
    ->ArgNames({"k", "bends", "hand"})
    ->ArgsProduct({{1, 10, 50, 100, 150}, {0, 1}, {0}})
    ->ArgsProduct({{50, 150}, {0, 1}, {1, 2, 3}})
    ->Iterations(50000);
BENCHMARK(relaxing_tick)->ArgName("k")->Arg(10)->Arg(50)->Arg(150)->Iterations(50000);
BENCHMARK(changeover_tick)->ArgName("k")->Arg(10)->Arg(50)->Arg(150)->Iterations(500);
BENCHMARK(display_field)->ArgName("k")->Arg(10)->Arg(50)->Arg(150)->Iterations(500)->Unit(benchmark::kMillisecond);

}  // namespace
