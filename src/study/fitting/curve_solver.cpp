#include "study/fitting/curve_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "study/fitting/curve_shape.h"
#include <Eigen/QR>

namespace bodkin::study {

namespace {

constexpr double just_below = 1.0 - 1e-12;    // so that rounding does not put the yield off by a tick
constexpr std::size_t places_per_sample = 6;  // places tried between two samples
constexpr double clear_fall = 8.0;            // times the noise: no other start is needed
constexpr int first_steps = 12;               // of a start among others
constexpr int rounds = 6;                     // of moving the yield
constexpr std::size_t reach = 18;             // places on either side that are tried at once
constexpr std::size_t farthest = 60;          // places on either side of the yield that are tried

// The best that the smooth parameters can do about residuals, to first order. Their slopes at a solution will do for
// its neighbourhood: they change only between the two ticks.
YieldCandidate candidate(std::size_t tick, const Eigen::VectorXd& residuals,
                         const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& slope) {
  YieldCandidate result{tick, residuals.squaredNorm(), {}};
  if (slope.cols() == 0) return result;
  const Eigen::VectorXd turned = slope.householderQ().adjoint() * residuals;
  result.sum_of_squares = turned.tail(turned.size() - slope.rank()).squaredNorm();
  const Eigen::VectorXd shift = slope.solve(-residuals);
  result.shift.assign(shift.begin(), shift.end());
  return result;
}

}  // namespace

CurveSolver::CurveSolver(const FitModel& model, const MeasuredCurve& curve, std::vector<NeedleHistory> histories,
                         std::vector<bool> counts)
    : model_(model), curve_(curve), histories_(std::move(histories)) {
  for (const NeedleHistory& one : histories_) {
    const auto before = static_cast<double>(history_.ticks.size());
    history_.dt = one.dt;
    history_.ticks.insert(history_.ticks.end(), one.ticks.begin(), one.ticks.end());
    for (const double place : one.places) history_.places.push_back(before + place);
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i]) rows_.push_back(i);
  const double ticks_per_sample = history_.places.back() / static_cast<double>(curve.size() - 1);
  grid_step_ = std::max<std::size_t>(1, static_cast<std::size_t>(ticks_per_sample) / places_per_sample);
}

std::vector<std::size_t> CurveSolver::smooth() const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < looked_for.size(); ++i)
    if (looked_for[i] && !(model_.yield && *model_.yield == i)) found.push_back(i);
  return found;
}

double CurveSolver::scale_of(std::size_t parameter, const std::vector<double>& values) const {
  const double size = std::max(std::abs(values[parameter]), std::abs(model_.parameters[parameter].usual));
  return size > 0.0 ? size : 1.0;
}

double CurveSolver::yield_value(const std::vector<double>& values, std::size_t tick) const {
  return model_.yields_in(values, history_.ticks[tick]);
}

void CurveSolver::set_yield(CurveSolution& solution) const {
  if (!yields()) return;
  const std::size_t yield = *model_.yield;
  const double value = solution.yield_tick ? just_below * yield_value(solution.values, *solution.yield_tick)
                                           : std::numeric_limits<double>::infinity();
  solution.values[yield] = std::clamp(value, low[yield], high[yield]);
}

std::vector<double> CurveSolver::force_at_samples(const std::vector<double>& values) const {
  std::vector<double> ticks(history_.ticks.size()), sampled(curve_.size());
  std::size_t first = 0;
  for (const NeedleHistory& one : histories_) {
    model_.simulate(values, one, std::span(ticks).subspan(first, one.ticks.size()));
    first += one.ticks.size();
  }
  at_samples(history_, ticks, sampled);
  return sampled;
}

LeastSquaresProblem CurveSolver::problem(const std::vector<std::size_t>& parameters,
                                         const CurveSolution& around) const {
  LeastSquaresProblem result;
  result.samples = rows_.size();
  for (const std::size_t i : parameters) {
    result.low.push_back(low[i]);
    result.high.push_back(high[i]);
    result.scale.push_back(scale_of(i, around.values));
  }
  result.residuals = [this, parameters, around](std::span<const double> x, std::span<double> residuals) {
    CurveSolution here = around;
    for (std::size_t i = 0; i < parameters.size(); ++i) here.values[parameters[i]] = x[i];
    set_yield(here);
    const std::vector<double> force = force_at_samples(here.values);
    for (std::size_t i = 0; i < rows_.size(); ++i) residuals[i] = force[rows_[i]] - curve_.force[rows_[i]];
  };
  return result;
}

CurveSolution CurveSolver::settle(CurveSolution solution, int steps) const {
  const std::vector<std::size_t> parameters = smooth();
  const LeastSquaresProblem equations = problem(parameters, solution);
  std::vector<double> x;
  for (const std::size_t i : parameters) x.push_back(solution.values[i]);
  x = least_squares(equations, x, steps);
  for (std::size_t i = 0; i < parameters.size(); ++i) solution.values[parameters[i]] = x[i];
  set_yield(solution);
  std::vector<double> residuals(rows_.size());
  equations.residuals(x, residuals);
  solution.sum_of_squares = 0.0;
  for (const double r : residuals) solution.sum_of_squares += r * r;
  return solution;
}

CurveSolution CurveSolver::begin_with(std::size_t yield_sample) const {
  CurveSolution solution;
  solution.values = kept;
  const double contact = model_.contact && !looked_for[*model_.contact] ? kept[*model_.contact] : contact_of(curve_);
  std::vector<double> guessed = kept;
  model_.guess(shape_of(curve_, contact, yield_sample), guessed);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (looked_for[i]) solution.values[i] = std::clamp(start[i].value_or(guessed[i]), low[i], high[i]);
  if (yields() && yield_sample > 0)
    solution.yield_tick =
        static_cast<std::size_t>(0.5 * (history_.places[yield_sample - 1] + history_.places[yield_sample]));
  set_yield(solution);
  return solution;
}

Eigen::VectorXd CurveSolver::residuals_with(const CurveSolution& solution, std::size_t tick) const {
  CurveSolution moved = solution;
  moved.yield_tick = tick;
  set_yield(moved);
  const std::vector<double> force = force_at_samples(moved.values);
  Eigen::VectorXd residuals(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i)
    residuals(static_cast<Eigen::Index>(i)) = force[rows_[i]] - curve_.force[rows_[i]];
  return residuals;
}

std::optional<std::size_t> CurveSolver::neighbouring_tick(const CurveSolution& solution, int direction,
                                                          std::size_t steps) const {
  const std::size_t far = steps * grid_step_, here = *solution.yield_tick;
  if (direction < 0 ? far > here : here + far >= history_.ticks.size()) return std::nullopt;
  return direction < 0 ? here - far : here + far;
}

CurveSolution CurveSolver::improve(CurveSolution solution) const {
  solution = settle(std::move(solution));
  if (!yields() || !solution.yield_tick) return solution;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> slope(sensitivity(solution, smooth()));
    std::size_t best = *solution.yield_tick;
    double least = solution.sum_of_squares;
    for (const int direction : {-1, 1}) {
      for (std::size_t n = 1; n <= reach; ++n) {
        const std::optional<std::size_t> tick = neighbouring_tick(solution, direction, n);
        if (!tick || !(yield_value(solution.values, *tick) > 0.0)) break;
        const double sum = candidate(*tick, residuals_with(solution, *tick), slope).sum_of_squares;
        if (sum >= least) continue;
        least = sum;
        best = *tick;
      }
    }
    if (best == *solution.yield_tick) break;
    CurveSolution moved = solution;
    moved.yield_tick = best;
    moved = settle(std::move(moved));
    if (moved.sum_of_squares >= solution.sum_of_squares) break;
    solution = std::move(moved);
  }
  return solution;
}

CurveSolution CurveSolver::solve() const {
  const std::vector<std::size_t> falls = falls_of(curve_, 4);
  if (!yields()) {
    const bool broken = model_.yield.has_value() && !falls.empty();
    return settle(begin_with(broken ? falls.front() : 0));
  }
  std::vector<std::size_t> starts = {0};  // nothing gives direction
  if (!falls.empty()) {
    const CurveShape steepest = shape_of(curve_, 0.0, falls.front());
    const bool clear = steepest.peak_force - steepest.after_force > clear_fall * noise_of(curve_);
    starts.insert(
        starts.end(), falls.begin(),
        clear ? falls.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(2, falls.size())) : falls.end());
    if (!clear) {
      for (std::size_t part = 1; part < 5; ++part) starts.push_back(part * curve_.size() / 5);
    }
  }
  CurveSolution best;
  best.sum_of_squares = std::numeric_limits<double>::infinity();
  for (const std::size_t sample : starts) {
    CurveSolution begun = begin_with(sample);
    if (sample > 0 && !(yield_value(begun.values, *begun.yield_tick) > 0.0)) continue;
    CurveSolution solution = settle(std::move(begun), first_steps);
    if (solution.sum_of_squares < best.sum_of_squares) best = std::move(solution);
  }
  return improve(std::move(best));
}

std::vector<YieldCandidate> CurveSolver::alternatives(const CurveSolution& solution, double allowed,
                                                      bool& bounded) const {
  std::vector<YieldCandidate> found;
  bounded = true;
  if (!yields() || !solution.yield_tick) return found;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> slope(sensitivity(solution, smooth()));
  for (const int direction : {-1, 1}) {
    int misses = 0;
    for (std::size_t n = 1; misses < 2; ++n) {
      const std::optional<std::size_t> tick = neighbouring_tick(solution, direction, n);
      if (!tick || n > farthest) {
        bounded = false;
        break;
      }
      if (!(yield_value(solution.values, *tick) > 0.0)) break;
      YieldCandidate other = candidate(*tick, residuals_with(solution, *tick), slope);
      if (other.sum_of_squares > allowed) {
        ++misses;
        continue;
      }
      found.push_back(std::move(other));
    }
  }
  return found;
}

std::vector<CurveSolution> CurveSolver::neighbours(const CurveSolution& solution,
                                                   const std::vector<std::size_t>& parameters,
                                                   const std::vector<double>& errors) const {
  std::vector<CurveSolution> found;
  for (const std::size_t jumpy : model_.jumpy) {
    const auto place = std::find(parameters.begin(), parameters.end(), jumpy);
    if (place == parameters.end()) continue;
    const double error = errors[static_cast<std::size_t>(place - parameters.begin())];
    for (const double away : {-3.0, -1.5, 1.5, 3.0}) {
      CurveSolution begun = solution;
      begun.values[jumpy] = std::clamp(begun.values[jumpy] + away * error, low[jumpy], high[jumpy]);
      found.push_back(settle(std::move(begun)));
    }
  }
  return found;
}

Eigen::MatrixXd CurveSolver::sensitivity(const CurveSolution& solution,
                                         const std::vector<std::size_t>& parameters) const {
  std::vector<double> x;
  for (const std::size_t i : parameters) x.push_back(solution.values[i]);
  return jacobian(problem(parameters, solution), x);
}

Eigen::VectorXd CurveSolver::yield_gradient(const CurveSolution& solution, const std::vector<std::size_t>& parameters,
                                            std::size_t tick) const {
  Eigen::VectorXd gradient(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double step = 1e-6 * scale_of(parameters[i], solution.values);
    std::vector<double> up = solution.values, down = solution.values;
    up[parameters[i]] += step;
    down[parameters[i]] -= step;
    gradient(static_cast<Eigen::Index>(i)) = (yield_value(up, tick) - yield_value(down, tick)) / (2.0 * step);
  }
  return gradient;
}

}  // namespace bodkin::study
