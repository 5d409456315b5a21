#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "study/fitting/fit_model.h"
#include "study/fitting/measured_curve.h"

namespace bodkin::study {

// A value for a parameter by its name.
using NamedValue = std::pair<std::string, double>;

struct ParameterBounds {
  std::string name;
  double low = 0.0, high = 0.0;
};

// The fit requested.
struct FitRequest {
  std::string model;
  std::optional<double> speed;                             // mm/s, 0.01 to 1000; for curves without time
  double resolution = 0.0;                                 // mm, of the measured depth, 0 to 1; 0 = noiseless
  double from = -std::numeric_limits<double>::infinity();  // mm; only samples from here ...
  double to = std::numeric_limits<double>::infinity();     // ... to here count
  std::vector<NamedValue> fix;                             // kept at a value
  std::vector<NamedValue> start;                           // started at a value
  std::vector<ParameterBounds> bounds;                     // narrower than the model's own
  std::vector<std::string> free;                           // fitted although the model usually fixes them
  // mm below the skin at which layers begin, the first 0, ascending: a value for each layer; for the models of
  // fit_stack(). May be empty: one tissue.
  std::vector<double> layers;
};

enum class ParameterStatus {
  estimated,
  kept,           // by the user or because the model usually fixes it
  at_bound,       // the best value is the end of its range
  not_identified  // the data do not determine it; kept at its usual or given value
};

struct FittedParameter {
  std::string name, unit;
  double value = 0.0;
  ParameterStatus status = ParameterStatus::kept;
  double standard_error = 0.0;   // of estimated ones ...
  double low = 0.0, high = 0.0;  // ... and its interval in the joint 95 % confidence region of all
  std::string remark;            // why it was not estimated
};

struct CurveFit {
  std::string model;
  std::vector<FittedParameter> parameters;  // in the model's order
  std::size_t samples = 0;                  // used samples
  double r_squared = 0.0;                   // NaN if the measured force is constant and there is nothing to explain
  // Akaike's criterion with the correction for few samples; smaller is better, between models of the same samples.
  double aic = 0.0;
  double rmse = 0.0;               // N
  std::vector<double> yields_at;   // mm, depths of punctures: one, or in a stack one for each punctured layer
  std::vector<double> force;       // N, the model's, at every sample of the curve
  std::vector<std::string> notes;  // one sentence each
  FittedElements elements;

  const FittedParameter* find(std::string_view name) const noexcept;
};

// Bounded nonlinear least squares of a model's force against a measured curve (docs/fit.md has method and limits).
// Deterministic. Throws InputError for names, values and ranges that do not fit the model, for too few samples, and
// for a curve without time if the model needs it.
CurveFit fit_curve(const MeasuredCurve& curve, const FitRequest& request);
// One set of values for several curves at once, each from fresh tissue; `force` has the samples of all, one after the
// other.
CurveFit fit_curves(std::span<const MeasuredCurve> curves, const FitRequest& request);

// Every model fitted to the same curves, the best by `aic` first. With `layers` the models that support layers are
// fitted as stacks, the others as one tissue.
struct ModelChoice {
  std::vector<CurveFit> fits;
  std::vector<std::pair<std::string, std::string>> refused;  // model and reason
};
// `request` without model, fix, start, bounds and free. Throws InputError when no model can be fitted.
ModelChoice choose_model(std::span<const MeasuredCurve> curves, const FitRequest& request);

// The fitted values as an XML document: elements of the tissue library and of a case, ready to be copied.
std::string fitted_xml(const CurveFit& fit, const MeasuredCurve& curve);

}  // namespace bodkin::study
