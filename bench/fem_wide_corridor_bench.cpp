// A corridor so wide that a needle may enter where it likes: 50 mm wide and 80 mm deep, in a box of 120 x 120 x 100
// mm whose mesh is fine there and coarse elsewhere. What it takes to prepare, what ways at random find in it, and
// what a tick costs with so large a compliance. It needs 4 GB and comes only when BODKIN_LARGE_BODIES is set.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "tests/fem/lattice_body.h"
#include <benchmark/benchmark.h>

#include "fem/embedded_needle.h"
#include "fem/solid/elastic_body.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::fem;

constexpr double width = 50.0, depth = 80.0, side = 120.0, height = 100.0;  // mm
constexpr double fine = 10.0 / 3.0;                                         // mm between the corridor's nodes
constexpr double reach = 2.4;  // mm from any line to a node of each layer: half a diagonal of a cell
constexpr int ways = 200;

// Places along one axis: fine from `from` to `to`, wider and wider towards `end`.
std::vector<double> graded(double from, double to, double end) {
  std::vector<double> places;
  for (int i = 0; from + fine * i < to + 1e-6; ++i) places.push_back(from + fine * i);
  constexpr double growth = 1.35;
  for (double step = fine * growth; end - places.back() > 0.7 * step; step *= growth)
    places.push_back(std::min(end, places.back() + step));
  places.back() = end;
  return places;
}

BodyDescription graded_body() {
  std::vector<double> across;
  const std::vector<double> half = graded(0.5 * fine, 0.5 * width, 0.5 * side);
  for (auto place = half.rbegin(); place != half.rend(); ++place) across.push_back(-*place);
  across.insert(across.end(), half.begin(), half.end());
  const std::vector<double> down = graded(0.0, depth, height);
  const auto n = static_cast<std::uint32_t>(across.size()), layers = static_cast<std::uint32_t>(down.size());
  BodyDescription body;
  // Numbered along x, y and z in turn; z is turned round so that elements keep their sense.
  body.mesh = kuhn_box({n, n, layers}, Vec3(1.0, 1.0, 1.0));
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
    const std::uint32_t layer = layers - 1 - node / (n * n);
    Vec3& place = body.mesh.nodes[node];
    place = Vec3(across[node % n], across[node / n % n], -down[layer]);
    if (layer + 1 == layers) {
      body.fixed.push_back(node);
    } else if (-place.z() <= depth + 1e-6 && place.head<2>().norm() <= 0.5 * width) {
      body.corridor.push_back(node);
    }
  }
  body.materials = soft_and_ligament();
  return body;
}

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

void wide_corridor(benchmark::State& state) {
  const BodyDescription description = graded_body();
  CondensedBody body;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    body = condense(description);
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  ContactTissues tissues;
  tissues.fill({.friction = 0.02});
  EmbeddedNeedleSettings settings;
  settings.capture_radius = reach;
  settings.spacing = fine;
  settings.most_nodes = 60;
  EmbeddedNeedle needle(body, tissues, settings, 1e-3);
  Random random(1);
  std::vector<double> times;
  double nodes = 0.0, fewest = 1e9, most_resistance = 0.0, least_resistance = 1e9;
  int beyond = 0;
  const auto anywhere = [&random](double z) {  // within the corridor, off its rim
    Vec3 place;
    do {
      place = Vec3(random.uniform(-0.5 * width, 0.5 * width), random.uniform(-0.5 * width, 0.5 * width), z);
    } while (place.head<2>().norm() > 0.5 * width - reach);
    return place;
  };
  for (int way = 0; way < ways; ++way) {
    const Vec3 entry = anywhere(0.0), along = (anywhere(-depth) - entry).normalized();
    needle.reset();
    needle.begin(entry, along);
    const double deep = 0.95 * depth / std::abs(along.z());
    for (double tip = -1.0; tip < deep; tip += 0.1) {  // 100 mm/s
      const Pose pose = needle_pose(entry + tip * along, along);
      const double start = processor_time();
      needle.step(pose);
      times.push_back(processor_time() - start);
    }
    const EmbeddedNeedleForce& force = needle.step(needle_pose(entry + deep * along, along));
    nodes += force.nodes;
    fewest = std::min(fewest, static_cast<double>(force.nodes) / deep);
    most_resistance = std::max(most_resistance, force.resistance);
    least_resistance = std::min(least_resistance, force.resistance);
    beyond += force.beyond || force.full || force.fault ? 1 : 0;
  }
  std::sort(times.begin(), times.end());
  state.counters["mesh_nodes"] = static_cast<double>(description.mesh.nodes.size());
  state.counters["corridor_nodes"] = static_cast<double>(body.nodes.size());
  state.counters["compliance_MB"] = 8e-6 * static_cast<double>(body.compliance.size());
  state.counters["held"] = nodes / ways;
  state.counters["mm_a_node_at_most"] = 1.0 / fewest;
  state.counters["ways_that_leave_it"] = beyond;
  state.counters["least_N"] = least_resistance;
  state.counters["most_N"] = most_resistance;
  state.counters["median_us"] = times[times.size() / 2];
  state.counters["p99.9_us"] = times[static_cast<std::size_t>(0.999 * static_cast<double>(times.size() - 1))];
}

const bool wide_registered = [] {
  if (std::getenv("BODKIN_LARGE_BODIES") != nullptr)
    benchmark::RegisterBenchmark("wide_corridor", wide_corridor)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
  return true;
}();

}  // namespace
