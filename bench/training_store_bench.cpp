// The cost of a cohort table: 100 000 attempts of 1000 trainees at 2 procedures, read from a store in a file.
#include <filesystem>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "training/store/cohort_table.h"
#include "training/store/result_store.h"

namespace {

namespace fs = std::filesystem;
using namespace bodkin::training;

constexpr int attempts_of_all = 100'000, trainees = 1000;

const fs::path& filled_store() {
  static const fs::path file = [] {
    fs::path made = fs::temp_directory_path() / ("bodkin_store_bench_" + std::to_string(getpid()) + ".sqlite");
    std::vector<AttemptRecord> records;
    for (int number = 0; number < attempts_of_all; ++number) {
      AttemptRecord record;
      record.digest = std::to_string(number);
      record.trainee = "trainee-" + std::to_string(number % trainees);
      record.procedure = number / trainees % 2 == 0 ? "lumbar_puncture" : "epidural";
      record.started_at = std::to_string(1'000'000 + number);
      record.verdict = number % 7 == 0 ? Grade::fail : Grade::pass;
      record.score = number % 101;
      for (int metric = 0; metric < 45; ++metric)
        record.metrics.emplace_back("metric_" + std::to_string(metric), 0.1 * metric);
      records.push_back(std::move(record));
    }
    ResultStore(made.string()).add(records);
    return made;
  }();
  return file;
}

void cohort_table_of_100000_attempts(benchmark::State& state) {
  ResultStore store(filled_store().string());
  for (auto _ : state) {
    const std::vector<CohortRow> rows = cohort_table(store.summaries());
    benchmark::DoNotOptimize(rows.data());
    if (rows.size() != 2 * trainees) state.SkipWithError("rows are missing");
  }
}
BENCHMARK(cohort_table_of_100000_attempts)->Unit(benchmark::kMillisecond);

}  // namespace
