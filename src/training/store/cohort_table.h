#pragma once

#include <string>
#include <vector>

#include "training/cusum.h"
#include "training/store/result_store.h"

namespace bodkin::training {

// Performance of one trainee at one procedure.
struct CohortRow {
  std::string trainee;
  std::string procedure;
  int attempts = 0, passed = 0, borderline = 0, failed = 0, dangerous = 0;
  int last_in_a_row = 0;  // consecutive passes at the end
  double score = 0.0;     // mean of the last `recent_attempts`, 0 to 100
  bool mastery = false;   // CUSUM has crossed its lower limit, and not its upper one since then
  std::string last_at;    // ISO 8601, UTC
};
inline constexpr int recent_attempts = 5;

// One row for each trainee and procedure, in their order. `attempts`: from ResultStore::summaries().
std::vector<CohortRow> cohort_table(const std::vector<AttemptSummary>& attempts, const CusumSettings& settings = {});

// The curve of one trainee at one procedure: a fail or dangerous attempt is a failure.
std::vector<Cusum::Point> learning_curve(const std::vector<AttemptSummary>& attempts,
                                         const CusumSettings& settings = {});

}  // namespace bodkin::training
