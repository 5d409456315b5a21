#include "study/fitting/simulate.h"

#include <algorithm>

#include <fmt/format.h>

#include "forces/voigt_law.h"

namespace bodkin::study {

double cubic_per_stiffness(double spacing, double depth) {
  return forces::VoigtLaw(forces::VoigtSum::cubic, 1.0, 0.0, spacing).elastic(std::max(depth, 0.01));
}

void add_for_layers(FitModel& model, std::size_t layers, const FitParameter& one) {
  for (std::size_t i = 0; i < layers; ++i) {
    model.parameters.push_back(one);
    model.parameters.back().name = fmt::format("{}_{}", one.name, i + 1);
  }
}

FitParameter contact_parameter() {
  return {.name = "contact", .unit = "mm", .low = -1000.0, .high = 1000.0, .fitted = false};
}

void add_tops(FitModel& model, std::span<const double> tops) {
  for (std::size_t i = 0; i < tops.size(); ++i) {
    FitParameter top = fit_parameter(&anatomy::TrackingWallDepthLayer::from,
                                     {.usual = tops[i], .most = deepest_layer, .fitted = false});
    top.name += fmt::format("_{}", i + 1);
    model.parameters.push_back(std::move(top));
  }
}

}  // namespace bodkin::study
