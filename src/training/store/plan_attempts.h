#pragma once

#include <string>
#include <vector>

#include "training/plan_progress.h"
#include "training/store/result_store.h"

namespace bodkin::training {

// What a trainee has done of a plan, in the order of time.
std::vector<StageAttempt> plan_attempts(ResultStore& store, const std::string& plan, const std::string& trainee);

}  // namespace bodkin::training
