#pragma once

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "training/plan_progress.h"
#include "training/store/plan_attempts.h"

namespace bodkin::app {

// How far a trainee is in a plan, as the store has it.
struct PlanStanding {
  std::string name;     // of the plan as it was asked for, a file or one that comes with Bodkin
  std::string trainee;  // empty: none was asked for, and nothing is known of attempts
  training::PlanInUse use;
  std::vector<training::StageAttempt> attempts;         // of the plan, in the order of time
  std::vector<training::AttemptSummary> of_every_kind;  // all of this trainee
  std::string trouble;                                  // why there is no plan or no store, one sentence; empty: none

  bool has_plan() const { return !use.plan.stages.empty(); }
  training::PlanProgress progress() const { return training::progress_in(use.plan, attempts); }
};

// Reads a plan, looks for every name in it, delivers what waits for the store, and looks there how far the trainee
// is. May take seconds where the store is a server. What fails is said in `trouble`.
PlanStanding read_standing(const std::string& plan, const std::string& trainee);

// "Stage 2 of 3: Without the planned path. 1 of 2 passed in a row, attempt 3 of 10"; or that it is finished.
std::string standing_words(const PlanStanding& standing);

// A trainee on the way through a plan. Results go into the store on a thread of their own, one after the other; what
// the store cannot take waits on this station.
class TrainingRun {
 public:
  explicit TrainingRun(PlanStanding standing) : standing_(std::move(standing)) {}
  // Waits until everything is kept.
  ~TrainingRun() = default;
  TrainingRun(const TrainingRun&) = delete;
  TrainingRun& operator=(const TrainingRun&) = delete;

  const PlanStanding& standing() const noexcept { return standing_; }
  // From 1; one more than the plan has: it is finished.
  int stage_number() const { return standing_.progress().stage; }
  // That is to be done; nothing: the plan is finished.
  std::optional<training::PlanStage> stage() const;

  // An attempt in the present stage; the session of it belongs to the store from now on.
  void keep(training::AttemptRecord record);
  // Waits until everything is kept, and returns the sentences of take_note().
  std::string finish();
  // Why a result waits on this station, once; empty: none does.
  std::string take_note();

 private:
  PlanStanding standing_;
  std::vector<std::shared_future<std::string>> kept_;  // in order; each waits for the one before
};

}  // namespace bodkin::app
