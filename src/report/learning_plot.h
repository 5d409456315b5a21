#pragma once

#include <string>
#include <vector>

#include "imaging/canvas.h"
#include "training/store/cohort_table.h"

namespace bodkin::report {

// The learning curve of one trainee at one procedure: CUSUM against the number of the attempt, a dot at each crossing
// of a limit, and below it the score of each attempt. `attempts`: in chronological order, at least one.
imaging::Canvas draw_learning_curve(const std::vector<training::AttemptSummary>& attempts,
                                    const training::CusumSettings& settings = {});

}  // namespace bodkin::report
