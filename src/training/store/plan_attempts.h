#pragma once

#include <string>
#include <vector>

#include "training/plan_progress.h"
#include "training/store/result_store.h"

namespace bodkin::training {

// A trainee's attempts in a plan, in chronological order.
std::vector<StageAttempt> plan_attempts(ResultStore& store, const std::string& plan, const std::string& trainee);

// A plan, and its document as stored.
struct PlanInUse {
  Plan plan;
  std::string document;
};

// A plan that comes with Bodkin, by its name, or a file. Throws InputError when there is none, and for the first name
// in it that does not exist.
PlanInUse read_plan_in_use(const std::string& name);

// Assigns attempts of one trainee, at least one, to the stages of the plan, which is added to the store. Each belongs
// to the stage that the trainee has reached by the earlier ones, in chronological order, in which `records` are
// sorted. One already in the store keeps its stage there; those after the end of the plan have none. Does not store
// the records themselves. Throws what ResultStore throws.
void put_in_stages(const PlanInUse& use, ResultStore& store, std::vector<AttemptRecord>& records);

}  // namespace bodkin::training
