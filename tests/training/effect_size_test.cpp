#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "session/operator_file.h"
#include "tests/training/lumbar_patient.h"
#include "tests/training/page_table.h"
#include <gtest/gtest.h>

#include "training/procedure_file.h"
#include "training/score.h"
#include "training/simulated_attempt.h"

// The metrics distinguish novices from experts: the purpose of a simulated cohort before rules meet real trainees.

namespace bodkin {

using namespace bodkin::training;
namespace {

constexpr int attempts_of_each = 20;

std::vector<Score> scores_of(const std::string& performer) {
  const anatomy::Case& patient = lumbar_patient();
  const simulation::OperatorScript script = session::load_operator(performer);
  const training::Procedure procedure = find_procedure("lumbar_puncture");
  std::vector<Score> scores;
  for (int seed = 1; seed <= attempts_of_each; ++seed) {
    const session::Session session =
        simulate_attempt(patient, script, *patient.description.procedure.path, static_cast<std::uint64_t>(seed));
    scores.push_back(score(session, patient.description, procedure, {&patient.structures, &patient.tissues}));
  }
  return scores;
}

struct Spread {
  double mean = 0.0, variance = 0.0, count = 0.0;
};

Spread spread_of(const std::vector<Score>& scores, std::string_view metric) {
  Spread spread;
  double squares = 0.0;
  for (const Score& each : scores) {
    const MetricResult* const result = each.find(metric);
    if (result == nullptr) continue;
    spread.count += 1.0;
    spread.mean += result->value;
    squares += result->value * result->value;
  }
  spread.mean /= spread.count;
  spread.variance = (squares - spread.count * spread.mean * spread.mean) / (spread.count - 1.0);
  return spread;
}

// Hedges' g: the difference of the means in pooled standard deviations, corrected for small samples (Hedges 1981).
double effect_size(const Spread& one, const Spread& other) {
  const double freedom = one.count + other.count - 2.0;
  const double pooled = ((one.count - 1.0) * one.variance + (other.count - 1.0) * other.variance) / freedom;
  return (other.mean - one.mean) / std::sqrt(pooled) * (1.0 - 3.0 / (4.0 * freedom - 1.0));
}

TEST(EffectSize, metrics_separate_novices_from_experts) {
  const std::vector<Score> experts = scores_of("expert"), novices = scores_of("novice");
  std::string table = "| metric | experts, mean | novices, mean | Hedges' g |\n|---|---|---|---|\n";
  // Above 0.8 an effect is called large (Cohen 1988).
  for (const char* metric : {"final_lateral_mm", "entry_distance_mm", "deviation_rms_mm", "angle_at_contact_deg",
                             "loss_overshoot_mm", "loss_speed_mm_per_s", "loss_approach_mm_per_s",
                             "path_inefficiency_percent", "swept_area_mm2", "tremor_mm", "mean_speed_mm_per_s"}) {
    const Spread of_experts = spread_of(experts, metric), of_novices = spread_of(novices, metric);
    const double effect = effect_size(of_experts, of_novices);
    EXPECT_GT(effect, 0.8) << metric;
    std::ostringstream row;
    row << std::fixed << std::setprecision(2) << "| `" << metric << "` | " << of_experts.mean << " | "
        << of_novices.mean << " | " << std::setprecision(1) << effect << " |\n";
    table += row.str();
  }
  int passed_experts = 0, passed_novices = 0;
  for (const Score& each : experts) passed_experts += each.verdict == Grade::pass ? 1 : 0;
  for (const Score& each : novices) passed_novices += each.verdict == Grade::pass ? 1 : 0;
  EXPECT_GE(passed_experts, attempts_of_each - 1);
  EXPECT_LT(passed_novices, attempts_of_each / 2);
  expect_table_on_page("cohorts.md", "| metric | experts, mean |", table, 0.05);
}

}  // namespace
}  // namespace bodkin
