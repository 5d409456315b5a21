#pragma once

#include <string>
#include <vector>

#include "training/store/attempt_record.h"

namespace bodkin::training {

// Attempts as a table for statistics, RFC 4180: one row each; trainee, procedure, plan, stage, time, station,
// patient, duration, verdict, whether the goal was reached, score, and a column for each metric. Missing values are
// empty.
std::string results_csv(const std::vector<AttemptRecord>& attempts);

}  // namespace bodkin::training
