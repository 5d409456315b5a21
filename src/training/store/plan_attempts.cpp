#include "training/store/plan_attempts.h"

namespace bodkin::training {

std::vector<StageAttempt> plan_attempts(ResultStore& store, const std::string& plan, const std::string& trainee) {
  std::vector<StageAttempt> attempts;
  for (const AttemptSummary& each : store.summaries_of_plan(plan, trainee))
    attempts.push_back({each.stage, each.verdict, each.score});
  return attempts;
}

}  // namespace bodkin::training
