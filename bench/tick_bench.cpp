// HapticTick::step, tissue look-up included, on the lumbar torso that `./run` uses and on a body of many slabs. The
// input is recorded beforehand: a needle that goes in at 10 mm/s and comes out again, over and over, warm.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "patient/synthetic/lumbar.h"
#include "tests/simulation/slab_patient.h"
#include <benchmark/benchmark.h>

#include "io/tissue_library_file.h"
#include "simulation/haptic_tick.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
using namespace bodkin::simulation;

std::vector<TickInput> in_and_out(const NeedlePath& path, double beyond) {
  std::vector<TickInput> inputs;
  const double length = path.length() + beyond;
  const int ticks = static_cast<int>(2.0 * (length + 5.0) / 0.01);
  for (int tick = 0; tick < ticks; ++tick) {
    const double depth = -5.0 + (length + 5.0) * 0.5 * (1.0 - std::cos(2.0 * 3.14159265358979323846 * tick / ticks));
    inputs.push_back(needle_at(Vec3(path.entry + depth * path.direction()), path.direction()));
  }
  return inputs;
}

struct Scene {
  Case patient;
  std::vector<TickInput> inputs;
};

Scene lumbar_scene(Mechanics mechanics) {
  Scene made;
  made.patient.description.haptics.mechanics = mechanics;
  made.patient.library = default_tissue_library();
  SyntheticPatient torso = synthesize_lumbar({}, made.patient.library);
  made.patient.tissues = std::move(torso.tissues);
  made.inputs = in_and_out(torso.path, 5.0);
  return made;
}

// With the tables of forces, and with forces that follow from the needle, as a new case has them.
const Scene& lumbar() {
  static const Scene scene = lumbar_scene(Mechanics::tables);
  return scene;
}
const Scene& described_lumbar() {
  static const Scene scene = lumbar_scene(Mechanics::physical);
  return scene;
}

// Skin, fat and muscle in turn, 6 mm each, in 300^3 voxels: 17 tissues along 100 mm.
const Scene& slabs() {
  static const Scene scene = [] {
    Scene made;
    made.patient.library = slab_library();
    Grid grid;
    grid.size = {300, 300, 300};
    made.patient.tissues = TissueVolume(grid);
    const TissueId turn[] = {tissue::skin, tissue::fat, tissue::muscle};
    for (std::size_t k = 0; k < 300; ++k) {
      std::fill_n(made.patient.tissues.voxels.begin() + static_cast<std::ptrdiff_t>(k * 90000), 90000,
                  turn[k / 6 % 3]);
    }
    made.inputs = in_and_out({{150.0, 140.0, -0.5}, {155.0, 150.0, 95.0}}, 0.0);
    return made;
  }();
  return scene;
}

// Throughput, in batches of one whole insertion.
void batch(benchmark::State& state, const Scene& scene) {
  HapticTick tick(scene.patient);
  for (auto _ : state) {
    for (const TickInput& input : scene.inputs) benchmark::DoNotOptimize(tick.step(input));
  }
  const double steps = static_cast<double>(state.iterations()) * static_cast<double>(scene.inputs.size());
  state.counters["per_tick"] = benchmark::Counter(steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// Every tick on its own, clock included (20 to 40 ns).
void single(benchmark::State& state, const Scene& scene) {
  HapticTick tick(scene.patient);
  std::vector<double> times;
  times.reserve(scene.inputs.size() * 100);
  for (const TickInput& input : scene.inputs) benchmark::DoNotOptimize(tick.step(input));  // warm
  for (auto _ : state) {
    for (const TickInput& input : scene.inputs) {
      const auto start = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(tick.step(input));
      const auto end = std::chrono::steady_clock::now();
      times.push_back(std::chrono::duration<double, std::nano>(end - start).count());
    }
  }
  std::sort(times.begin(), times.end());
  const auto at = [&times](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };
  state.counters["median_ns"] = at(0.5);
  state.counters["p99_ns"] = at(0.99);
  state.counters["p99.9_ns"] = at(0.999);
  state.counters["max_ns"] = times.back();
}

void lumbar_batch(benchmark::State& state) {
  batch(state, lumbar());
}
void described_lumbar_batch(benchmark::State& state) {
  batch(state, described_lumbar());
}
void slabs_batch(benchmark::State& state) {
  batch(state, slabs());
}
void lumbar_single_tick(benchmark::State& state) {
  single(state, lumbar());
}
void described_lumbar_single_tick(benchmark::State& state) {
  single(state, described_lumbar());
}
void slabs_single_tick(benchmark::State& state) {
  single(state, slabs());
}

BENCHMARK(slabs_batch)->Unit(benchmark::kMillisecond);
BENCHMARK(slabs_single_tick)->Unit(benchmark::kMillisecond)->Iterations(50);
BENCHMARK(lumbar_batch)->Unit(benchmark::kMillisecond);
BENCHMARK(lumbar_single_tick)->Unit(benchmark::kMillisecond)->Iterations(50);
BENCHMARK(described_lumbar_batch)->Unit(benchmark::kMillisecond);
BENCHMARK(described_lumbar_single_tick)->Unit(benchmark::kMillisecond)->Iterations(50);

}  // namespace
