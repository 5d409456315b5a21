#pragma once

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "training/plan_progress.h"
#include "training/store/plan_attempts.h"

namespace bodkin::app {

// A trainee's progress in a plan, from the store.
struct PlanStanding {
  std::string name;     // of the plan as requested, a file or a plan supplied with Bodkin
  std::string trainee;  // empty: none was given, and no attempts are known
  training::PlanInUse use;
  std::vector<training::StageAttempt> attempts;         // of the plan, in the order of time
  std::vector<training::AttemptSummary> of_every_kind;  // all attempts of this trainee
  std::string trouble;                                  // why there is no plan or no store, one sentence; empty: none

  bool has_plan() const { return !use.plan.stages.empty(); }
  training::PlanProgress progress() const { return training::progress_in(use.plan, attempts); }
};

// Reads a plan, resolves all names in it, delivers waiting results to the store, and looks up the trainee's progress.
// May take seconds with a server. Errors are in `trouble`.
PlanStanding read_standing(const std::string& plan, const std::string& trainee);

// "Stage 2 of 3: Without the planned path. 1 of 2 passed in a row, attempt 3 of 10"; or that it is finished.
std::string standing_words(const PlanStanding& standing);

// A trainee's progress through a plan. Results are stored on a separate thread, one after the other; results that the
// store cannot accept wait on this station.
class TrainingRun {
 public:
  explicit TrainingRun(PlanStanding standing) : standing_(std::move(standing)) {}
  // Waits until everything is stored.
  ~TrainingRun() = default;
  TrainingRun(const TrainingRun&) = delete;
  TrainingRun& operator=(const TrainingRun&) = delete;

  const PlanStanding& standing() const noexcept { return standing_; }
  // From 1; one more than the number of stages: finished.
  int stage_number() const { return standing_.progress().stage; }
  // The next stage; empty: the plan is finished.
  std::optional<training::PlanStage> stage() const;

  // Stores an attempt of the present stage; its session then belongs to the store.
  void keep(training::AttemptRecord record);
  // Waits until everything is stored, and returns the sentences of take_note().
  std::string finish();
  // Why a result waits on this station, once; empty: none does.
  std::string take_note();

 private:
  PlanStanding standing_;
  std::vector<std::shared_future<std::string>> kept_;  // in order; each waits for the previous one
};

}  // namespace bodkin::app
