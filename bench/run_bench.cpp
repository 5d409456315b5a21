// A whole lumbar puncture by the expert on the lumbar torso that `./run` uses: operator, hand, tick and, in the
// second benchmark, the recording to a session file. The counter `times_real_time` is the promise of `bodkin run`
// (200 or more).
#include <filesystem>
#include <string>

#include "patient/synthetic/lumbar.h"
#include "session/operator_file.h"
#include "session/session_run.h"
#include <benchmark/benchmark.h>
#include <unistd.h>

#include "io/tissue_library_file.h"
#include "simulation/closed_loop.h"

namespace {

using namespace bodkin;
using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
using namespace bodkin::session;
using namespace bodkin::simulation;

const Case& lumbar() {
  static const Case patient = [] {
    Case made;
    made.library = default_tissue_library();
    SyntheticPatient torso = synthesize_lumbar({}, made.library);
    made.tissues = std::move(torso.tissues);
    made.description.procedure.path = torso.path;
    return made;
  }();
  return patient;
}

void report(benchmark::State& state, double simulated) {
  state.counters["times_real_time"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}

void expert_without_recording(benchmark::State& state) {
  const Case& patient = lumbar();
  const OperatorScript script = load_operator("expert");
  double simulated = 0.0;
  for (auto _ : state) {
    ClosedLoop loop(patient, script, *patient.description.procedure.path, 1);
    TickRecord record;
    while (!loop.finished()) loop.step(record);
    benchmark::DoNotOptimize(record);
    simulated += static_cast<double>(record.tick + 1) * loop.dt();
  }
  report(state, simulated);
}
BENCHMARK(expert_without_recording)->Unit(benchmark::kMillisecond);

void expert_recorded(benchmark::State& state) {
  const Case& patient = lumbar();
  RunSettings settings;
  settings.script = load_operator("expert");
  settings.path = *patient.description.procedure.path;
  settings.output =
      std::filesystem::temp_directory_path() / ("bodkin_run_bench_" + std::to_string(getpid()) + ".bodkin");
  settings.overwrite = true;
  SessionHeader header;
  header.dt = 1.0 / patient.description.haptics.rate;
  header.path = settings.path;
  header.haptics = patient.description.haptics;
  double simulated = 0.0;
  for (auto _ : state) {
    const RunResult result = run_session(patient, header, settings, {});
    simulated += static_cast<double>(result.ticks) * header.dt;
  }
  std::filesystem::remove(settings.output);
  report(state, simulated);
}
BENCHMARK(expert_recorded)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
