#include "training/store/plan_attempts.h"

#include <algorithm>
#include <filesystem>

#include "io/resources.h"

namespace bodkin::training {

namespace {

constexpr std::size_t largest_plan_document = 1 << 20;  // bytes

}  // namespace

std::vector<StageAttempt> plan_attempts(ResultStore& store, const std::string& plan, const std::string& trainee) {
  std::vector<StageAttempt> attempts;
  for (const AttemptSummary& each : store.summaries_of_plan(plan, trainee))
    attempts.push_back({each.stage, each.verdict, each.score});
  return attempts;
}

PlanInUse read_plan_in_use(const std::string& name) {
  const std::filesystem::path file = find_plan(name);
  PlanInUse use{read_plan(file), io::read_text_file(file, largest_plan_document)};
  check_names(use.plan, file.string());
  return use;
}

void put_in_stages(const PlanInUse& use, ResultStore& store, std::vector<AttemptRecord>& records) {
  store.put_plan({use.plan.name, use.plan.title, use.document});
  std::vector<StageAttempt> done = plan_attempts(store, use.plan.name, records.front().trainee);
  std::sort(records.begin(), records.end(), [](const auto& a, const auto& b) { return a.started_at < b.started_at; });
  for (AttemptRecord& each : records) {
    if (store.attempt(each.digest)) continue;
    const int stage = progress_in(use.plan, done).stage;
    if (stage > static_cast<int>(use.plan.stages.size())) break;  // the plan is finished
    each.plan = use.plan.name;
    each.stage = stage;
    done.push_back({stage, each.verdict, each.score});
  }
}

}  // namespace bodkin::training
