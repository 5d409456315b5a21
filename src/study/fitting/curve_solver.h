#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "study/fitting/fit_model.h"
#include "study/fitting/least_squares.h"
#include "study/fitting/measured_curve.h"
#include "study/fitting/needle_history.h"
namespace bodkin::study {

// The values of a model that are looked for and those that are kept, and how well they describe the curve.
struct CurveSolution {
  std::vector<double> values;  // all of the model's parameters
  // For each of the model's `yields` where that tissue gives way, if it is looked for; none: nowhere.
  std::vector<std::optional<std::size_t>> yield_ticks;
  double sum_of_squares = 0.0;  // N^2
};

// A place where a tissue may have given way, and what that would mean.
struct YieldCandidate {
  std::size_t tick = 0;
  double sum_of_squares = 0.0;  // N^2, of the best values with it, to first order
  std::vector<double> shift;    // of the smooth parameters, to first order
};

// Least squares of a model against a curve. The force jumps where a tissue gives way, so the sum of squares jumps
// with the parameter that decides it; such a parameter is looked for as a tick of the history, with all others, which
// are smooth then, fitted for each. In a stack there is one for each layer.
class CurveSolver {
 public:
  // `curve`: the samples of one curve or of several, one after the other; `histories`: one for each, in their order.
  // The tissue is fresh at the beginning of each.
  CurveSolver(const FitModel& model, const MeasuredCurve& curve, std::vector<NeedleHistory> histories,
              std::vector<bool> counts);

  // Which parameters are looked for, and within what. `start` has values that the user gave, none otherwise.
  std::vector<bool> looked_for;
  std::vector<double> low, high, kept;
  std::vector<std::optional<double>> start;

  // The best solution from several starts.
  CurveSolution solve() const;
  // The best solution near another one.
  CurveSolution improve(CurveSolution solution) const;
  // The other ticks at which the tissue of yields[which] may have given way as far as the data show: those whose sum
  // of squares is at most `allowed`, neighbours first; empty when it gives way nowhere. `bounded`: false when they
  // never end.
  std::vector<YieldCandidate> alternatives(const CurveSolution& solution, std::size_t which, double allowed,
                                           bool& bounded) const;

  // Best solutions that begin where a parameter of the model's `jumpy` ones is a few of its standard errors away:
  // `errors` of `parameters`, in the units of the parameters. The sum of squares may have a lower place there.
  std::vector<CurveSolution> neighbours(const CurveSolution& solution, const std::vector<std::size_t>& parameters,
                                        const std::vector<double>& errors) const;

  // The parameters looked for that are smooth.
  std::vector<std::size_t> smooth() const;
  // d force / d parameter at the samples that count, for the given parameters.
  Eigen::MatrixXd sensitivity(const CurveSolution& solution, const std::vector<std::size_t>& parameters) const;
  // The places in the model's `yields` that are looked for.
  std::vector<std::size_t> yields() const;
  // The value of yields[which] with which its tissue gives way at `tick`, and its derivatives.
  double yield_value(const std::vector<double>& values, std::size_t which, std::size_t tick) const;
  Eigen::VectorXd yield_gradient(const CurveSolution& solution, const std::vector<std::size_t>& parameters,
                                 std::size_t which, std::size_t tick) const;

  // N, at every sample of the curve.
  std::vector<double> force_at_samples(const std::vector<double>& values) const;
  const NeedleHistory& history() const noexcept { return history_; }
  std::size_t counted() const noexcept { return rows_.size(); }
  std::size_t grid_step() const noexcept { return grid_step_; }
  double scale_of(std::size_t parameter, const std::vector<double>& values) const;

 private:
  static constexpr int all_steps = 60;

  // For each of the model's yields the sample at which it may begin; 0: nowhere.
  using YieldSamples = std::vector<std::size_t>;

  LeastSquaresProblem problem(const std::vector<std::size_t>& parameters, const CurveSolution& around) const;
  CurveSolution settle(CurveSolution solution, int steps = all_steps) const;
  std::vector<YieldSamples> starts_of_one(const std::vector<std::size_t>& falls) const;
  std::vector<YieldSamples> starts_of_several() const;
  // Of the deepest of several curves by itself: where it gives way says nothing wrong about the others yet.
  CurveSolution solution_of_deepest() const;
  CurveSolution begin_with(const YieldSamples& samples) const;
  void set_yields(CurveSolution& solution) const;
  // The tick `steps` places before (direction -1) or after (1) another; none beyond the history.
  std::optional<std::size_t> neighbouring_tick(std::size_t tick, int direction, std::size_t steps) const;
  Eigen::VectorXd residuals_with(const CurveSolution& solution, std::size_t which, std::size_t tick) const;

  const FitModel& model_;
  const MeasuredCurve& curve_;
  std::vector<NeedleHistory> histories_;
  NeedleHistory history_;          // all of them, one after the other
  std::vector<std::size_t> rows_;  // samples that count
  std::size_t grid_step_ = 1;      // ticks between two places where a tissue may give way
};

}  // namespace bodkin::study
