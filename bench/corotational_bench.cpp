// Cost of a step of a moving body, at the sizes of design/numerics.md: a box of 100 mm, held at its bottom and
// pressed at its top by a face of 40 x 15 mm that goes in and out by 15 mm once a second, at 60 steps a second.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "tests/fem/lattice_body.h"
#include <benchmark/benchmark.h>

#include "fem/moving/corotational_body.h"

namespace {

using namespace bodkin;
using namespace bodkin::fem;

constexpr double side = 100.0;  // mm

// ms of CPU time of this thread.
double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

std::vector<std::uint32_t> pressed_nodes(const BodyDescription& body) {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
    const Vec3& x = body.mesh.nodes[node];
    if (x.z() > side - 1e-6 && std::abs(x.x() - 0.5 * side) < 20.0 && std::abs(x.y() - 0.5 * side) < 7.5)
      nodes.push_back(node);
  }
  return nodes;
}

void press(const BodyDescription& body, const std::vector<std::uint32_t>& nodes, double depth,
           CorotationalBody& moving) {
  for (const std::uint32_t node : nodes) moving.hold(node, body.mesh.nodes[node] - Vec3(0.0, 0.0, depth));
}

void step(benchmark::State& state) {
  const BodyDescription body = lattice_body(static_cast<std::uint32_t>(state.range(0)), side, 0.1, 200);
  const auto nodes = pressed_nodes(body);
  CorotationalBody moving(body, CorotationalSettings{});
  std::vector<double> times;
  double iterations = 0.0, halvings = 0.0;
  int number = 0;
  const auto next = [&] {
    press(body, nodes, 7.5 * (1.0 - std::cos(2.0 * 3.14159265358979323846 * ++number / 60.0)), moving);
    return moving.step();
  };
  for (int warm = 0; warm < 30; ++warm) next();
  for (auto _ : state) {
    const double start = processor_ms();
    const CorotationalStep told = next();
    times.push_back(processor_ms() - start);
    iterations += told.iterations;
    halvings += told.halvings;
    if (told.fault) state.SkipWithError("a step failed");
  }
  std::sort(times.begin(), times.end());
  const auto part = [&times](double of) {
    return times[static_cast<std::size_t>(of * static_cast<double>(times.size() - 1))];
  };
  state.counters["nodes"] = static_cast<double>(body.mesh.nodes.size());
  state.counters["elements"] = static_cast<double>(body.mesh.elements.size());
  state.counters["min_ms"] = times.front();
  state.counters["median_ms"] = part(0.5);
  state.counters["p99_ms"] = part(0.99);
  state.counters["iterations"] = iterations / static_cast<double>(times.size());
  state.counters["halvings"] = halvings / static_cast<double>(times.size());
}

BENCHMARK(step)->Arg(13)->Arg(17)->Arg(18)->Iterations(600)->Unit(benchmark::kMillisecond);

}  // namespace
