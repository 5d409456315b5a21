#pragma once

#include <string>
#include <vector>

#include "training/plan_progress.h"
#include "training/store/result_store.h"

namespace bodkin::training {

// What a trainee has done of a plan, in the order of time.
std::vector<StageAttempt> plan_attempts(ResultStore& store, const std::string& plan, const std::string& trainee);

// A plan, and the document that the store keeps of it.
struct PlanInUse {
  Plan plan;
  std::string document;
};

// A plan that comes with Bodkin, by its name, or a file. Throws InputError when there is none, and for the first name
// in it of what does not exist.
PlanInUse read_plan_in_use(const std::string& name);

// Puts attempts of one trainee, at least one, in the stages of the plan, which the store keeps from now on. Each
// belongs to the stage that the trainee has come to by those before it, in the order of time, in which `records` are
// sorted. One that the store has already keeps the stage that it has there; those after the end of the plan belong to
// none. The records themselves are not kept by this. Throws what ResultStore throws.
void put_in_stages(const PlanInUse& use, ResultStore& store, std::vector<AttemptRecord>& records);

}  // namespace bodkin::training
