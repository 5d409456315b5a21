#include "app/models/training_run.h"

#include <chrono>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "training/store/outbox.h"
#include "training/store/store_place.h"

namespace bodkin::app {

namespace {

// Why it waits; empty: the store has it.
std::string deliver(const training::PlanInUse& use, training::AttemptRecord record) {
  try {
    const std::string place = training::store_place();
    training::Outbox outbox(place, training::outbox_folder());
    std::vector<training::AttemptRecord> records = {std::move(record)};
    try {
      if (outbox.waiting() > 0) outbox.deliver();
      training::ResultStore store(place);
      training::put_in_stages(use, store, records);
    } catch (const std::exception&) {
      // It keeps the stage counted by the window, and the outbox reports why it waits.
    }
    return outbox.add(records.front()).reason;
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

PlanStanding read_standing(const std::string& plan, const std::string& trainee) {
  PlanStanding standing;
  standing.name = plan;
  standing.trainee = trainee;
  try {
    standing.use = training::read_plan_in_use(plan);
    if (trainee.empty()) return standing;
    training::check_label(trainee, "the trainee");
    const std::string place = training::store_place();
    training::Outbox outbox(place, training::outbox_folder());
    if (outbox.waiting() > 0) outbox.deliver();
    training::ResultStore store(place);
    standing.attempts = training::plan_attempts(store, standing.use.plan.name, trainee);
    standing.of_every_kind = store.summaries(trainee);
  } catch (const std::exception& error) {
    standing.trouble = error.what();
  }
  return standing;
}

std::string standing_words(const PlanStanding& standing) {
  const training::PlanProgress progress = standing.progress();
  const std::vector<training::PlanStage>& stages = standing.use.plan.stages;
  if (progress.stage > static_cast<int>(stages.size())) return "The plan is finished";
  const training::PlanStage& stage = stages[static_cast<std::size_t>(progress.stage - 1)];
  return fmt::format("Stage {} of {}: {}. {}", progress.stage, stages.size(), stage.title,
                     training::progress_words(stage, progress.here));
}

std::optional<training::PlanStage> TrainingRun::stage() const {
  const auto number = static_cast<std::size_t>(stage_number());
  const std::vector<training::PlanStage>& stages = standing_.use.plan.stages;
  return number <= stages.size() ? std::optional(stages[number - 1]) : std::nullopt;
}

void TrainingRun::keep(training::AttemptRecord record) {
  if (!stage()) return;
  record.trainee = standing_.trainee;
  record.plan = standing_.use.plan.name;
  record.stage = stage_number();
  record.owns_file = true;
  standing_.attempts.push_back({record.stage, record.verdict, record.score});
  standing_.of_every_kind.push_back({record.trainee, record.procedure, record.started_at, record.digest,
                                     record.verdict, record.score, record.stage});
  std::shared_future<std::string> before;
  if (!kept_.empty()) before = kept_.back();
  kept_.push_back(std::async(std::launch::async, [use = standing_.use, record = std::move(record), before] {
                    if (before.valid()) before.wait();
                    return deliver(use, record);
                  }).share());
}

std::string TrainingRun::finish() {
  for (const std::shared_future<std::string>& each : kept_) each.wait();
  return take_note();
}

std::string TrainingRun::take_note() {
  while (!kept_.empty() && kept_.front().wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    std::string reason = kept_.front().get();
    kept_.erase(kept_.begin());
    if (!reason.empty()) return reason;
  }
  return {};
}

}  // namespace bodkin::app
