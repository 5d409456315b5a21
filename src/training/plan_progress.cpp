#include "training/plan_progress.h"

#include <algorithm>

#include <fmt/format.h>

#include "training/cusum.h"

namespace bodkin::training {

bool counts_as_passed(const PlanStage& stage, Grade verdict, double score) {
  return verdict == Grade::pass && score >= stage.score_from;
}

StageProgress progress_in(const PlanStage& stage, std::span<const StageAttempt> attempts) {
  StageProgress progress;
  std::vector<char> failed;
  bool row_was_long_enough = false;
  for (const StageAttempt& each : attempts) {
    ++progress.attempts;
    progress.in_a_row = counts_as_passed(stage, each.verdict, each.score) ? progress.in_a_row + 1 : 0;
    row_was_long_enough = row_was_long_enough || (stage.passes > 0 && progress.in_a_row >= stage.passes);
    failed.push_back(each.verdict >= Grade::fail ? 1 : 0);
  }
  const std::vector<Cusum::Point> curve = Cusum({}).curve(failed);
  progress.mastery = std::any_of(curve.begin(), curve.end(), [](const Cusum::Point& point) { return point.mastery; });
  const bool has_criterion = stage.passes > 0 || stage.mastery;
  progress.is_passed =
      has_criterion && (stage.passes == 0 || row_was_long_enough) && (!stage.mastery || progress.mastery);
  progress.is_done = progress.is_passed || (!stage.must_pass && progress.attempts >= stage.attempts);
  return progress;
}

PlanProgress progress_in(const Plan& plan, std::span<const StageAttempt> attempts) {
  PlanProgress progress;
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    progress.stage = static_cast<int>(i + 1);
    std::vector<StageAttempt> here;
    std::copy_if(attempts.begin(), attempts.end(), std::back_inserter(here),
                 [&](const StageAttempt& each) { return each.stage == progress.stage; });
    progress.here = progress_in(plan.stages[i], here);
    if (!progress.here.is_done) return progress;
  }
  progress.stage = static_cast<int>(plan.stages.size()) + 1;
  return progress;
}

std::string progress_words(const PlanStage& stage, const StageProgress& progress) {
  if (stage.passes > 0) {
    const std::string words =
        fmt::format("{} of {} passed in a row", std::min(progress.in_a_row, stage.passes), stage.passes);
    return stage.must_pass ? words
                           : fmt::format("{}, attempt {} of {}", words, progress.attempts + 1, stage.attempts);
  }
  if (stage.mastery && stage.must_pass)
    return fmt::format("attempt {}, mastery not shown yet", progress.attempts + 1);
  return fmt::format("attempt {} of {}", progress.attempts + 1, stage.attempts);
}

}  // namespace bodkin::training
