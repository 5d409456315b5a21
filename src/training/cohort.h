#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"
#include "fem/solid/contact_body.h"
#include "simulation/operator_script.h"
#include "training/plan.h"
#include "training/procedure.h"

namespace bodkin::training {

// A stage with its inputs, loaded.
struct CohortStage {
  PlanStage plan;
  Procedure procedure;
  const anatomy::Case* patient = nullptr;
  anatomy::NeedlePath path;
  std::shared_ptr<const fem::ContactBody> whole_body = {};  // AttemptOptions::whole_body
};

// One of several processes, on one machine or on many with a shared folder, that share a cohort: it computes the
// trainees whose number has the remainder `index` when divided by `count`.
struct CohortPart {
  std::uint64_t index = 0, count = 1;
};

struct CohortSettings {
  std::vector<CohortStage> stages;
  std::uint64_t trainees = 1;
  std::uint64_t seed = 1;
  // Who performs: an operator that never learns, or, without one, trainees between the next two.
  std::optional<simulation::OperatorScript> performer;
  simulation::OperatorScript novice, expert;
  std::string fingerprint;       // digest of all inputs; a table begun with another one is not continued
  std::filesystem::path output;  // the table
  int threads = 0;               // 0: one per core
  CohortPart part;
};

// Result of a whole cohort.
struct CohortResult {
  bool is_whole = true;  // false: other parts are still running, there is no table yet, and nothing is counted here
  std::uint64_t attempts = 0;
  std::uint64_t continued = 0;            // trainees completed by an earlier, interrupted call
  std::map<std::string, int> verdicts;    // by name
  std::vector<double> passed_by_attempt;  // fraction of the n-th attempts of all trainees that passed
  int mastered = 0;  // trainees whose CUSUM crossed the lower limit; 10 % failures acceptable, 30 % not
};

// Lets simulated trainees perform a plan on all cores and writes a table in CSV, one row for each attempt: trainee,
// stage, attempt, skill, verdict, every metric. An attempt depends only on the plan, the seed and the trainee's
// number, so that the table has the same bytes for any number of threads. Completed trainees are stored in
// `output`.partial: an interrupted call is continued by repeating it. Each of several parts keeps a file
// `output`.partial-1-of-4; the part that ends last combines them into the same bytes as a single process would have
// written. Throws InputError and SystemError.
CohortResult run_cohort(const CohortSettings& settings, const Progress& progress = {});

}  // namespace bodkin::training
