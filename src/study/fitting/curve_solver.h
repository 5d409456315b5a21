#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "study/fitting/fit_model.h"
#include "study/fitting/least_squares.h"
#include "study/fitting/measured_curve.h"
#include "study/fitting/needle_history.h"
namespace bodkin::study {

// The estimated and fixed values of a model, and how well they describe the curve.
struct CurveSolution {
  std::vector<double> values;  // all of the model's parameters
  // For each of the model's `yields` the tick of its puncture, if it is estimated; empty: no puncture.
  std::vector<std::optional<std::size_t>> yield_ticks;
  double sum_of_squares = 0.0;  // N^2
};

// A tick at which a tissue may have been punctured, and the consequences.
struct YieldCandidate {
  std::size_t tick = 0;
  double sum_of_squares = 0.0;  // N^2, of the best values with it, to first order
  std::vector<double> shift;    // of the smooth parameters, to first order
};

// Least squares of a model against a curve. The force jumps at a puncture, so the sum of squares is discontinuous in
// the parameter that determines it; such a parameter is searched as a tick of the history, with all others, which are
// smooth then, fitted for each. A stack has one for each layer.
class CurveSolver {
 public:
  // `curve`: the samples of one curve or of several, one after the other; `histories`: one for each, in their order.
  // The tissue is fresh at the beginning of each.
  CurveSolver(const FitModel& model, const MeasuredCurve& curve, std::vector<NeedleHistory> histories,
              std::vector<bool> counts);

  // Which parameters are estimated, and their bounds. `start` has the values stated by the user, otherwise none.
  std::vector<bool> looked_for;
  std::vector<double> low, high, kept;
  std::vector<std::optional<double>> start;

  // The best solution from several starts.
  CurveSolution solve() const;
  // The best solution near another one.
  CurveSolution improve(CurveSolution solution) const;
  // The other ticks at which the tissue of yields[which] may have been punctured according to the data: those whose
  // sum of squares is at most `allowed`, neighbours first; empty without a puncture. `bounded`: false when they never
  // end.
  std::vector<YieldCandidate> alternatives(const CurveSolution& solution, std::size_t which, double allowed,
                                           bool& bounded) const;

  // Best solutions starting where a parameter of the model's `jumpy` ones is a few of its standard errors away:
  // `errors` of `parameters`, in the units of the parameters. The sum of squares may be lower there.
  std::vector<CurveSolution> neighbours(const CurveSolution& solution, const std::vector<std::size_t>& parameters,
                                        const std::vector<double>& errors) const;

  // The estimated parameters that are smooth.
  std::vector<std::size_t> smooth() const;
  // d force / d parameter at the used samples, for the given parameters.
  Eigen::MatrixXd sensitivity(const CurveSolution& solution, const std::vector<std::size_t>& parameters) const;
  // The positions in the model's `yields` that are estimated.
  std::vector<std::size_t> yields() const;
  // The value of yields[which] at which its tissue is punctured at `tick`, and its derivatives.
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

  // For each of the model's yields the sample at which its puncture may begin; 0: none.
  using YieldSamples = std::vector<std::size_t>;

  LeastSquaresProblem problem(const std::vector<std::size_t>& parameters, const CurveSolution& around) const;
  CurveSolution settle(CurveSolution solution, int steps = all_steps) const;
  std::vector<YieldSamples> starts_of_one(const std::vector<std::size_t>& falls) const;
  std::vector<YieldSamples> starts_of_several() const;
  // Of only the deepest of several curves: its punctures do not yet mislead the others.
  CurveSolution solution_of_deepest() const;
  CurveSolution begin_with(const YieldSamples& samples) const;
  void set_yields(CurveSolution& solution) const;
  // The tick `steps` positions before (direction -1) or after (1) another; empty beyond the history.
  std::optional<std::size_t> neighbouring_tick(std::size_t tick, int direction, std::size_t steps) const;
  Eigen::VectorXd residuals_with(const CurveSolution& solution, std::size_t which, std::size_t tick) const;

  const FitModel& model_;
  const MeasuredCurve& curve_;
  std::vector<NeedleHistory> histories_;
  NeedleHistory history_;          // all of them, one after the other
  std::vector<std::size_t> rows_;  // used samples
  std::size_t grid_step_ = 1;      // ticks between two candidates for a puncture
};

}  // namespace bodkin::study
