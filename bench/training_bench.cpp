// The cost of scoring: a session of ten minutes that is already in memory, and a whole simulated attempt with its
// score, which is what a cohort does a thousand times.
#include <cmath>

#include "session/operator_file.h"
#include "tests/training/lumbar_patient.h"
#include <benchmark/benchmark.h>

#include "core/geometry.h"
#include "training/procedure_file.h"
#include "training/score.h"
#include "training/simulated_attempt.h"

namespace {

using namespace bodkin;

// A needle that goes in and out of a body all the time, with tremor.
session::Session ten_minutes() {
  session::Session session;
  session.header.path = {Vec3::Zero(), Vec3(0, 0, 50)};
  session.header.tissues = {{anatomy::tissue::fat, "fat", "fat"}};
  session.finished = true;
  session.ticks.resize(600000);
  for (std::size_t i = 0; i < session.ticks.size(); ++i) {
    simulation::TickRecord& record = session.ticks[i];
    const double t = 0.001 * static_cast<double>(i);
    record.tick = i;
    record.output.depth = 25.0 - 30.0 * std::cos(0.3 * t);
    record.input.needle = needle_pose(Vec3(0.1 * std::sin(60.0 * t), 0, record.output.depth), Vec3::UnitZ());
    record.output.in_contact = record.output.depth > 0.0;
    record.output.tissue = record.output.in_contact ? anatomy::tissue::fat : anatomy::tissue::air;
    record.output.resistance = record.output.in_contact ? 1.0 : 0.0;
  }
  return session;
}

void score_ten_minutes(benchmark::State& state) {
  const session::Session session = ten_minutes();
  const training::Procedure procedure = training::find_procedure("lumbar_puncture");
  for (auto _ : state) benchmark::DoNotOptimize(training::score(session, {}, procedure));
}
BENCHMARK(score_ten_minutes)->Unit(benchmark::kMillisecond);

void simulated_lumbar_puncture(benchmark::State& state) {
  const anatomy::Case& patient = lumbar_patient();
  const simulation::OperatorScript expert = session::load_operator("expert");
  const training::Procedure procedure = training::find_procedure("lumbar_puncture");
  std::uint64_t seed = 0;
  for (auto _ : state) {
    const session::Session session =
        training::simulate_attempt(patient, expert, *patient.description.procedure.path, ++seed);
    benchmark::DoNotOptimize(
        training::score(session, patient.description, procedure, {&patient.structures, &patient.tissues}));
  }
}
BENCHMARK(simulated_lumbar_puncture)->Unit(benchmark::kMillisecond);

}  // namespace
