#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/fitting/fit_parameter.h"
#include "study/fitting/needle_history.h"

namespace bodkin::study {

// Features of a curve before anything is fitted.
struct CurveShape {
  double contact = 0.0;      // mm, at which the force begins
  double peak_depth = 0.0;   // mm, ...
  double peak_force = 0.0;   // N, at the puncture; at the deepest point without one
  double after_force = 0.0;  // N, after the puncture
  double end_depth = 0.0;    // mm, ...
  double end_force = 0.0;    // N, at the deepest point
  double slope = 0.0;        // N/mm, straight line through the loaded part of the first insertion ...
  double intercept = 0.0;    // mm, ... and where it is zero
};

// The destination of the fitted values.
struct FittedElements {
  std::vector<io::XmlElement> tissues;       // in a <tissue> of the tissue library; of a stack one for each layer
  std::optional<io::XmlElement> resistance;  // in the <resistance> of a case
};

// A force model as a function of a few numbers and the needle's history. `values` always are all `parameters`, in
// their order and within their ranges.
struct FitModel {
  std::string_view name;
  std::vector<FitParameter>
      parameters;  // in order of importance: the last are given up first when the data do not determine them
  std::vector<std::size_t> yields;     // parameters that each determine a puncture, at which the force jumps
  std::optional<std::size_t> contact;  // depth at which the needle meets the tissue
  std::vector<std::size_t> jumpy;      // parameters that move smaller jumps of the force along the curve
  bool needs_time = false;             // the force depends on speed
  // Fills the force of every tick, N.
  void (*simulate)(std::span<const double> values, const NeedleHistory& history, std::span<double> force) = nullptr;
  // The value of yields[which] at which that tissue is punctured in this motion; 0 if impossible.
  double (*yields_in)(std::span<const double> values, const AxialMotion& motion, std::size_t which) = nullptr;
  // Starting values, from the curve's shape if the tissues of `yields` are punctured there: a shape for each, at
  // least one.
  void (*guess)(std::span<const CurveShape> shapes, std::span<double> values) = nullptr;
  FittedElements (*elements)(std::span<const double> values) = nullptr;
  // The same of a stack whose layers begin at `tops`; null for a model that knows no layers.
  FitModel (*stack)(std::span<const double> tops) = nullptr;
};

// All models that can be fitted, in the order of docs/fit.md.
const std::vector<FitModel>& fit_models();

// Throws InputError listing the available names.
const FitModel& fit_model(std::string_view name);

inline constexpr double deepest_layer = 500.0;  // mm, top of the last one: no measured curve is longer

// A model of a stack whose layers begin at `tops` (mm, the first 0, ascending): values for each layer, shared values
// once. Throws InputError for a model that does not support layers, and for depths that do not ascend from 0.
FitModel fit_stack(std::string_view name, std::span<const double> tops);

// The models whose force has no law of its own for tissue along the shaft ...
FitModel spring_damper_wall_fit();
FitModel tracking_wall_fit();
FitModel tracking_wall_stack_fit(std::span<const double> tops);
FitModel depth_profile_fit();
FitModel depth_profile_stack_fit(std::span<const double> tops);
// ... and those with one.
FitModel layered_fit();
FitModel layered_stack_fit(std::span<const double> tops);
FitModel three_component_fit();
FitModel fracture_fit();
FitModel shaft_friction_fit();
FitModel shaft_friction_stack_fit(std::span<const double> tops);

}  // namespace bodkin::study
