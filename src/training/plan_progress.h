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

// How far somebody is in a stage.
struct StageProgress {
  int attempts = 0;
  int in_a_row = 0;        // passed at the end
  bool mastery = false;    // shown by CUSUM, at any attempt
  bool is_passed = false;  // by its criteria
  bool is_done = false;    // the next stage may begin
};

// An attempt counts as passed: the verdict is a pass, and its score is not below the stage's.
bool counts_as_passed(const PlanStage& stage, Grade verdict, double score);

// After these attempts, in the order of time. A stage is passed when as many attempts in a row count as passed as it
// asks for, and CUSUM has shown mastery where it asks for that. It is done when it is passed, or, unless it must be
// passed, after its number of attempts. With neither criterion it is never passed early.
StageProgress progress_in(const PlanStage& stage, std::span<const StageAttempt> attempts);

// Where somebody is in a plan.
struct PlanProgress {
  int stage = 1;  // that is to be done, from 1; one more than the plan has: it is finished
  StageProgress here;
};
// After these attempts, of any stages, in the order of time.
PlanProgress progress_in(const Plan& plan, std::span<const StageAttempt> attempts);

// "2 of 3 passed in a row", "attempt 4 of 10", for the attempt that comes next.
std::string progress_words(const PlanStage& stage, const StageProgress& progress);

}  // namespace bodkin::training
