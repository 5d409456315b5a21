#pragma once

#include <span>
#include <string>
#include <vector>

#include "training/plan.h"
#include "training/procedure.h"

namespace bodkin::training {

// An attempt in a stage of a plan.
struct StageAttempt {
  int stage = 1;  // from 1
  Grade verdict = Grade::fail;
  double score = 0.0;  // 0 to 100
};

// A person's progress in a stage.
struct StageProgress {
  int attempts = 0;
  int in_a_row = 0;        // consecutive passes at the end
  bool mastery = false;    // shown by CUSUM, at any attempt
  bool is_passed = false;  // by its criteria
  bool is_done = false;    // the next stage may begin
};

// Whether an attempt counts as passed: the verdict is a pass, and its score is not below the stage's.
bool counts_as_passed(const PlanStage& stage, Grade verdict, double score);

// Progress after these attempts, in chronological order. A stage is passed when the required number of consecutive
// attempts count as passed, and CUSUM has shown mastery if required. It is done when it is passed, or, unless it must
// be passed, after its number of attempts. With neither criterion it is never passed early.
StageProgress progress_in(const PlanStage& stage, std::span<const StageAttempt> attempts);

// A person's position in a plan.
struct PlanProgress {
  int stage = 1;  // to be done next, from 1; one more than the plan has: finished
  StageProgress here;
};
// Position after these attempts, of any stages, in chronological order.
PlanProgress progress_in(const Plan& plan, std::span<const StageAttempt> attempts);

// "2 of 3 passed in a row", "attempt 4 of 10", for the next attempt.
std::string progress_words(const PlanStage& stage, const StageProgress& progress);

}  // namespace bodkin::training
