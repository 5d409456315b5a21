#pragma once

#include <vector>

#include "report/plot.h"
#include "study/experiment.h"

namespace bodkin::report {

// The panels of an experiment below each other. Published numbers are drawn as dashed lines over their windows, in
// the panels that show their quantity over time or depth.
std::vector<Plot> plots_of(const io::Experiment& experiment, const study::ExperimentRun& run);

}  // namespace bodkin::report
