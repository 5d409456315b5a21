// Rows of docs/numbers.md: a body of a given number of nodes, from its mesh to the display. Boxes of 100 mm with a
// slab of ligament, a corridor of 1,000 nodes. 2,197 nodes are those of the haptic loop of Sutherland et al. 2013.
// Sizes above 20,000 require BODKIN_LARGE_BODIES, as does a body whose mesh is fine about an oblique path.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/tick_times.h"
#include "tests/fem/lattice_body.h"
#include <benchmark/benchmark.h>

#include "fem/solid/condensed_cache.h"
#include "fem/solid/display_columns.h"
#include "fem/solid/elastic_body.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::fem;

constexpr std::size_t corridor_size = 1000;        // nodes
constexpr double side = 100.0;                     // mm
constexpr std::size_t seen_nodes = 160;            // of the corridor, with columns for the display: a whole shaft
constexpr int grid_points = 32, skin_points = 46;  // along each axis

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// MB, peak memory of this program since the last reset.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1000.0;
  return 0.0;
}

struct Preparation {
  double seconds = 0.0, peak_MB = 0.0;
};

// The box with 99,937 nodes, fine (0.4 to 1.4 mm) about a way that goes down at 27 degrees, coarse (up to 10 mm) at
// its sides. Layers are 1.4 mm apart everywhere. That is what `bodkin case mesh` makes about a planned path.
constexpr std::uint32_t graded_across = 37, graded_layers = 73;
constexpr double graded_slope = 0.5;

BodyDescription graded_body() {
  BodyDescription body;
  body.mesh = kuhn_box({graded_across, graded_across, graded_layers}, Vec3(2.0, 2.0, 1.0), 0.1);
  const auto graded = [](double place) { return std::sinh(2.9 * (place - 1.0)) / std::sinh(2.9); };  // -1 to 1
  for (Vec3& node : body.mesh.nodes) {
    const double middle = 0.5 * side + graded_slope * side * (node.z() - 0.5), across = graded(node.x());
    node = Vec3(middle + across * (across > 0.0 ? side - middle : middle), 0.5 * side * (1.0 + graded(node.y())),
                side * node.z());
  }
  layers_of_ligament(body, side);
  const Vec3 entry(0.5 * side * (1.0 + graded_slope), 0.5 * side, side);
  const Vec3 along = Vec3(-graded_slope, 0.0, -1.0).normalized();
  std::vector<std::pair<double, std::uint32_t>> near;
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
    const Vec3 place = body.mesh.nodes[node] - entry;
    if (body.mesh.nodes[node].z() > 0.12 * side) near.emplace_back(place.cross(along).norm(), node);
  }
  std::sort(near.begin(), near.end());
  for (std::size_t i = 0; i < corridor_size; ++i) body.corridor.push_back(near[i].second);
  return body;
}

constexpr std::uint32_t graded_box = 0;  // instead of a number of nodes along each side

struct BoxBody {
  BodyDescription description;
  CondensedBody condensed;
  Preparation preparation;  // only of the condensed body
};

// Prepared once for all rows of a size; only the last size is kept.
const BoxBody& box_of(std::uint32_t along) {
  static std::optional<std::uint32_t> kept;
  static std::unique_ptr<BoxBody> box;
  if (kept == along) return *box;
  box = std::make_unique<BoxBody>();
  kept = along;
  box->description = along == graded_box ? graded_body() : lattice_body(along, side, 0.1, corridor_size);
  std::ofstream("/proc/self/clear_refs") << "5";
  const double before = peak_memory(), start = wall_time();
  box->condensed = condense(box->description);
  box->preparation = {wall_time() - start, peak_memory() - before};
  return *box;
}

void prepare(benchmark::State& state) {
  const BoxBody& box = box_of(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) state.SetIterationTime(box.preparation.seconds);
  state.counters["nodes"] = static_cast<double>(box.description.mesh.nodes.size());
  state.counters["peak_MB"] = box.preparation.peak_MB;
}

// The same from the cache: digest of the mesh and the file.
void prepare_from_cache(benchmark::State& state) {
  const BoxBody& box = box_of(static_cast<std::uint32_t>(state.range(0)));
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "bodkin-fem-body-bench.condensed";
  save_condensed(file, box.condensed, digest_of(box.description));
  for (auto _ : state) benchmark::DoNotOptimize(condensed_with_cache(file, box.description));
  std::filesystem::remove(file);
}

// The display: a grid for warping ultrasound and re-slices, and a face of skin.
std::vector<Vec3> seen_points() {
  std::vector<Vec3> points;
  const double step = side / (grid_points - 1), skin_step = side / (skin_points - 1);
  for (int k = 0; k < grid_points; ++k)
    for (int j = 0; j < grid_points; ++j)
      for (int i = 0; i < grid_points; ++i) points.emplace_back(step * i, step * j, step * k);
  for (int j = 0; j < skin_points; ++j)
    for (int i = 0; i < skin_points; ++i) points.emplace_back(skin_step * i, skin_step * j, side);
  return points;
}

void display_field(benchmark::State& state) {
  const BoxBody& box = box_of(static_cast<std::uint32_t>(state.range(0)));
  const auto pushed = static_cast<std::size_t>(state.range(1));
  static std::map<std::uint32_t, std::pair<std::unique_ptr<DisplayField>, double>> fields;
  auto& of_body = fields[static_cast<std::uint32_t>(state.range(0))];
  std::unique_ptr<DisplayField>& field = of_body.first;
  double& seconds = of_body.second;
  static std::vector<std::uint32_t> nodes;
  const std::vector<Vec3> points = seen_points();
  if (!field) {
    const ElasticBody elastic(box.description, plan_body(box.description));  // with the whole factor
    nodes.assign(elastic.corridor().begin(), elastic.corridor().begin() + seen_nodes);
    const double start = wall_time();
    field =
        std::make_unique<DisplayField>(display_columns(elastic, find_points(box.description.mesh, points), nodes));
    seconds = wall_time() - start;
  }
  NodeForces forces;
  forces.count = pushed;
  std::vector<float> moved(3 * points.size());
  time_every_tick(state, 0, [&](int picture) {
    for (std::size_t i = 0; i < pushed; ++i) {
      forces.nodes[i] = {nodes[(i + static_cast<std::size_t>(picture) / 4) % seen_nodes], {0.01F, 0.02F, 0.03F}};
    }
    field->evaluate(forces, moved);
    benchmark::DoNotOptimize(moved.data());
  });
  state.counters["columns_s"] = seconds;
  state.counters["columns_MB"] = static_cast<double>(display_bytes(points.size(), nodes.size())) * 1e-6;
}

std::vector<std::int64_t> sizes() {
  std::vector<std::int64_t> along = {13, 27};
  if (std::getenv("BODKIN_LARGE_BODIES") != nullptr) along.push_back(46);
  if (std::getenv("BODKIN_HUGE_BODIES") != nullptr) along = {63};  // 250,047 nodes, 12 GB, some minutes
  return along;
}

// Size by size, because a body is prepared only once.
const bool registered = [] {
  benchmark::RegisterBenchmark("machine_itself", machine_itself)->Iterations(50000);
  for (const std::int64_t along : sizes()) {
    benchmark::RegisterBenchmark("prepare", prepare)
        ->Arg(along)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
    benchmark::RegisterBenchmark("prepare_from_cache", prepare_from_cache)
        ->Arg(along)
        ->UseRealTime()
        ->Iterations(3)
        ->Unit(benchmark::kSecond);
    for (const std::int64_t k : {10, 50, 150})
      benchmark::RegisterBenchmark("display_field", display_field)
          ->ArgNames({"along", "k"})
          ->Args({along, k})
          ->Iterations(500);
  }
  if (std::getenv("BODKIN_LARGE_BODIES") == nullptr) return true;
  benchmark::RegisterBenchmark("prepare", prepare)
      ->Arg(graded_box)
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kSecond);
  return true;
}();

}  // namespace
