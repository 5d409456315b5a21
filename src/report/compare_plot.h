#pragma once

#include <vector>

#include "report/material_depth.h"
#include "report/plot.h"
#include "study/compare.h"

namespace bodkin::report {

// Force over depth (insertion thick, withdrawal thin) and force over time, for draw_plots(). Tissues are bands; each
// model has its colour and its dashes, a variant the colour of its model. Forces far above the peak of the device are
// cut off. `depth`: the depth in the material throws InputError for a model that does not know it.
std::vector<Plot> comparison_plots(const study::Comparison& comparison, const anatomy::TissueLibrary& library,
                                   double peak_force, PlottedDepth depth = PlottedDepth::hand);

}  // namespace bodkin::report
