// From a mesh to a condensed body: time and memory over the number of nodes, with a corridor of 1,000 nodes. The
// meshes are boxes of 100 mm. The largest takes half a minute per run and requires BODKIN_LARGE_BODIES; threads: one
// per core, or BODKIN_FEM_THREADS.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "tests/fem/lattice_body.h"
#include <benchmark/benchmark.h>
#include <unistd.h>

#include "fem/solid/elastic_body.h"
#include "fem/solid/factor_cache.h"

namespace {

using namespace bodkin;
using namespace bodkin::fem;

constexpr std::size_t corridor = 1000;  // nodes
constexpr double side = 100.0;          // mm

FactorOptions options_of_environment() {
  FactorOptions options;
  if (const char* threads = std::getenv("BODKIN_FEM_THREADS")) options.threads = std::atoi(threads);
  return options;
}

// MB, peak memory of this program since the last reset.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1000.0;
  return 0.0;
}

void reset_peak_memory() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

void describe(benchmark::State& state, const BodyDescription& body, std::size_t bytes, double before) {
  state.counters["nodes"] = static_cast<double>(body.mesh.nodes.size());
  state.counters["announced_MB"] = static_cast<double>(bytes) * 1e-6;
  state.counters["peak_MB"] = peak_memory() - before;
}

BodyDescription box(const benchmark::State& state) {
  return lattice_body(static_cast<std::uint32_t>(state.range(0)), side, 0.1, corridor);
}

// Checks, equations, factor and compliance; `field`: with the factor stored for the displacement of all nodes.
void prepare(benchmark::State& state, bool field) {
  const BodyDescription body = box(state);
  reset_peak_memory();
  const double before = peak_memory();
  std::size_t bytes = 0;
  for (auto _ : state) {
    FactorOptions options = options_of_environment();
    options.keep_field = field;
    check_body(body);
    BodyPlan plan = plan_body(body);
    bytes = plan.symbolic.bytes(field);
    const ElasticBody elastic(body, std::move(plan), options);
    benchmark::DoNotOptimize(elastic.condensed());
  }
  describe(state, body, bytes, before);
}

void only_check(benchmark::State& state) {
  const BodyDescription body = box(state);
  for (auto _ : state) benchmark::DoNotOptimize(check_body(body));
}

void only_plan(benchmark::State& state) {
  const BodyDescription body = box(state);
  for (auto _ : state) benchmark::DoNotOptimize(plan_body(body));
}

void only_factorise(benchmark::State& state) {
  const BodyDescription body = box(state);
  const BodyPlan plan = plan_body(body);
  FactorOptions options = options_of_environment();
  options.keep_field = false;
  double operations = 0.0;
  for (auto _ : state) {
    const MultifrontalCholesky factor(plan.system.stiffness, plan.symbolic, options);
    operations += plan.symbolic.operations;
  }
  state.counters["flops"] = benchmark::Counter(operations, benchmark::Counter::kIsRate);
}

// The displacement of all nodes under forces on the corridor.
void field_of_corridor(benchmark::State& state) {
  const BodyDescription body = box(state);
  const ElasticBody elastic(body, plan_body(body), options_of_environment());
  const Eigen::MatrixXd forces = Eigen::MatrixXd::Constant(3 * static_cast<Eigen::Index>(corridor), 1, 1e-3);
  for (auto _ : state) benchmark::DoNotOptimize(elastic.displacement_by_corridor(forces));
}

// A body that a needle can enter anywhere: factorised, or with its factor from a file.
void contact_body(benchmark::State& state, bool kept) {
  const auto body = std::make_shared<const BodyDescription>(box(state));
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("bodkin_bench_" + std::to_string(getpid()) + ".factor");
  std::size_t bytes = 0;
  if (kept) contact_body_with_cache(file, body);
  for (auto _ : state) {
    const auto whole = contact_body_with_cache(kept ? file : std::filesystem::path(), body);
    bytes = whole->factor().bytes();
  }
  std::filesystem::remove(file);
  state.counters["nodes"] = static_cast<double>(body->mesh.nodes.size());
  state.counters["factor_MB"] = static_cast<double>(bytes) * 1e-6;
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Arg(13)->Arg(27)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
  if (std::getenv("BODKIN_LARGE_BODIES") != nullptr) bench->Arg(46);
}

BENCHMARK_CAPTURE(prepare, condensed, false)->Apply(sizes);
BENCHMARK_CAPTURE(prepare, with_field, true)->Apply(sizes);
BENCHMARK(only_check)->Apply(sizes);
BENCHMARK(only_plan)->Apply(sizes);
BENCHMARK(only_factorise)->Apply(sizes);
BENCHMARK(field_of_corridor)->Apply(sizes);
BENCHMARK_CAPTURE(contact_body, factorised, false)->Apply(sizes);
BENCHMARK_CAPTURE(contact_body, from_its_file, true)->Apply(sizes);

}  // namespace
