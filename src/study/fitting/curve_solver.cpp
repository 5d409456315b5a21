#include "study/fitting/curve_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "study/fitting/curve_shape.h"
#include "study/fitting/layer_falls.h"
#include <Eigen/QR>

namespace bodkin::study {

namespace {

constexpr double just_below = 1.0 - 1e-12;    // so that rounding does not shift the yield by a tick
constexpr std::size_t places_per_sample = 6;  // places tried between two samples
constexpr double clear_fall = 8.0;            // times the noise: then no other start is needed
constexpr int first_steps = 12;               // of a start among several
constexpr int steps_of_many = 20;             // of a start near a solution with several yields
constexpr std::size_t most_moves = 3;         // of a yield that are fully tried
constexpr double layer_fall = 4.0;            // times the noise: the fall of a layer
constexpr std::size_t most_falls = 40;
constexpr std::size_t starts_by_layers = 24, least_starts = 3;
constexpr double explained = 1.5;     // times the variance of the noise: then no other start is needed
constexpr int rounds = 6;             // of moving each yield
constexpr std::size_t reach = 18;     // places on either side that are tried together
constexpr std::size_t farthest = 60;  // places on either side of the yield that are tried

// The best fit of the residuals by the smooth parameters, to first order. Their slopes at a solution suffice for its
// neighbourhood: they change only between the two ticks.
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
    if (looked_for[i] && std::find(model_.yields.begin(), model_.yields.end(), i) == model_.yields.end())
      found.push_back(i);
  return found;
}

double CurveSolver::scale_of(std::size_t parameter, const std::vector<double>& values) const {
  const double size = std::max(std::abs(values[parameter]), std::abs(model_.parameters[parameter].usual));
  return size > 0.0 ? size : 1.0;
}

std::vector<std::size_t> CurveSolver::yields() const {
  std::vector<std::size_t> found;
  for (std::size_t which = 0; which < model_.yields.size(); ++which)
    if (looked_for[model_.yields[which]]) found.push_back(which);
  return found;
}

double CurveSolver::yield_value(const std::vector<double>& values, std::size_t which, std::size_t tick) const {
  return model_.yields_in(values, history_.ticks[tick], which);
}

void CurveSolver::set_yields(CurveSolution& solution) const {
  for (const std::size_t which : yields()) {
    const std::size_t yield = model_.yields[which];
    const std::optional<std::size_t> tick = solution.yield_ticks[which];
    const double value =
        tick ? just_below * yield_value(solution.values, which, *tick) : std::numeric_limits<double>::infinity();
    solution.values[yield] = std::clamp(value, low[yield], high[yield]);
  }
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
    set_yields(here);
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
  set_yields(solution);
  std::vector<double> residuals(rows_.size());
  equations.residuals(x, residuals);
  solution.sum_of_squares = 0.0;
  for (const double r : residuals) solution.sum_of_squares += r * r;
  return solution;
}

CurveSolution CurveSolver::begin_with(const YieldSamples& samples) const {
  CurveSolution solution;
  solution.values = kept;
  const double contact = model_.contact && !looked_for[*model_.contact] ? kept[*model_.contact] : contact_of(curve_);
  std::vector<CurveShape> shapes;
  for (const std::size_t sample : samples) shapes.push_back(shape_of(curve_, contact, sample));
  std::vector<double> guessed = kept;
  model_.guess(shapes, guessed);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (looked_for[i]) solution.values[i] = std::clamp(start[i].value_or(guessed[i]), low[i], high[i]);
  solution.yield_ticks.resize(model_.yields.size());
  for (const std::size_t which : yields()) {
    const std::size_t sample = samples[which];
    if (sample > 0)
      solution.yield_ticks[which] =
          static_cast<std::size_t>(0.5 * (history_.places[sample - 1] + history_.places[sample]));
  }
  set_yields(solution);
  return solution;
}

Eigen::VectorXd CurveSolver::residuals_with(const CurveSolution& solution, std::size_t which,
                                            std::size_t tick) const {
  CurveSolution moved = solution;
  moved.yield_ticks[which] = tick;
  set_yields(moved);
  const std::vector<double> force = force_at_samples(moved.values);
  Eigen::VectorXd residuals(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i)
    residuals(static_cast<Eigen::Index>(i)) = force[rows_[i]] - curve_.force[rows_[i]];
  return residuals;
}

std::optional<std::size_t> CurveSolver::neighbouring_tick(std::size_t tick, int direction, std::size_t steps) const {
  const std::size_t far = steps * grid_step_;
  if (direction < 0 ? far > tick : tick + far >= history_.ticks.size()) return std::nullopt;
  return direction < 0 ? tick - far : tick + far;
}

CurveSolution CurveSolver::improve(CurveSolution solution) const {
  solution = settle(std::move(solution));
  const std::vector<std::size_t> looked = yields();
  for (std::size_t round = 0; round < rounds * looked.size(); ++round) {
    if (std::none_of(looked.begin(), looked.end(),
                     [&](auto which) { return solution.yield_ticks[which].has_value(); }))
      break;
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> slope(sensitivity(solution, smooth()));
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> moves;  // sum of squares; yield, tick
    for (const std::size_t which : looked) {
      if (!solution.yield_ticks[which]) continue;
      for (const int direction : {-1, 1}) {
        for (std::size_t n = 1; n <= reach; ++n) {
          const std::optional<std::size_t> tick = neighbouring_tick(*solution.yield_ticks[which], direction, n);
          if (!tick || !(yield_value(solution.values, which, *tick) > 0.0)) break;
          const double sum = candidate(*tick, residuals_with(solution, which, *tick), slope).sum_of_squares;
          if (sum < solution.sum_of_squares) moves.push_back({sum, {which, *tick}});
        }
      }
    }
    std::stable_sort(moves.begin(), moves.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::size_t tried = std::min(moves.size(), looked.size() > 1 ? most_moves : 1);
    bool better = false;
    for (std::size_t i = 0; i < tried && !better; ++i) {
      const auto [which, tick] = moves[i].second;
      CurveSolution moved = solution;
      moved.yield_ticks[which] = tick;
      moved = settle(std::move(moved));
      better = moved.sum_of_squares < solution.sum_of_squares;
      if (better) solution = std::move(moved);
    }
    if (!better) break;
  }
  return solution;
}

std::vector<CurveSolver::YieldSamples> CurveSolver::starts_of_one(const std::vector<std::size_t>& falls) const {
  if (yields().empty()) return {{model_.yields.empty() || falls.empty() ? 0 : falls.front()}};
  std::vector<YieldSamples> starts = {{0}};  // no direction is determined
  if (falls.empty()) return starts;
  const CurveShape steepest = shape_of(curve_, 0.0, falls.front());
  const bool clear = steepest.peak_force - steepest.after_force > clear_fall * noise_of(curve_);
  for (std::size_t i = 0; i < falls.size() && (!clear || i < 2); ++i) starts.push_back({falls[i]});
  if (!clear) {
    for (std::size_t part = 1; part < 5; ++part) starts.push_back({part * curve_.size() / 5});
  }
  return starts;
}

// The falls of the curve, in the order of the layers.
std::vector<CurveSolver::YieldSamples> CurveSolver::starts_of_several() const {
  const CurveSolution begun = begin_with(YieldSamples(model_.yields.size(), 0));
  std::vector<LayerFall> falls;
  for (const std::size_t sample : falls_of(curve_, most_falls)) {
    const CurveShape shape = shape_of(curve_, 0.0, sample);
    if (shape.peak_force - shape.after_force < layer_fall * noise_of(curve_)) continue;
    const auto tick = static_cast<std::size_t>(history_.places[sample]);
    LayerFall fall{sample, 0};
    while (fall.layers < model_.yields.size() && yield_value(begun.values, fall.layers, tick) > 0.0) ++fall.layers;
    falls.push_back(fall);
  }
  const std::size_t layers = model_.yields.size();
  return shares_of_falls(falls, layers, std::max(least_starts, starts_by_layers / layers));
}

CurveSolution CurveSolver::solution_of_deepest() const {
  std::size_t chosen = 0, first = 0, next = 0;
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    const auto begin = curve_.depth.begin() + static_cast<std::ptrdiff_t>(next);
    const double reached = *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(histories_[i].places.size()));
    if (reached > deepest) {
      deepest = reached;
      chosen = i;
      first = next;
    }
    next += histories_[i].places.size();
  }
  const auto part = [&](const auto& values) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    return std::decay_t<decltype(values)>(begin,
                                          begin + static_cast<std::ptrdiff_t>(histories_[chosen].places.size()));
  };
  MeasuredCurve curve;
  curve.depth = part(curve_.depth);
  curve.force = part(curve_.force);
  std::vector<bool> counts(curve_.size());
  for (const std::size_t row : rows_) counts[row] = true;
  CurveSolver alone(model_, curve, {histories_[chosen]}, part(counts));
  alone.looked_for = looked_for;
  alone.low = low;
  alone.high = high;
  alone.kept = kept;
  alone.start = start;
  CurveSolution solution = alone.solve();
  std::size_t before = 0;  // ticks
  for (std::size_t i = 0; i < chosen; ++i) before += histories_[i].ticks.size();
  for (std::optional<std::size_t>& tick : solution.yield_ticks)
    if (tick) *tick += before;
  return solution;
}

CurveSolution CurveSolver::solve() const {
  const bool several = model_.yields.size() > 1;
  if (several && histories_.size() > 1) return improve(solution_of_deepest());
  const std::vector<YieldSamples> starts = several ? starts_of_several() : starts_of_one(falls_of(curve_, 4));
  if (yields().empty()) return settle(begin_with(starts.front()));
  CurveSolution best;
  best.sum_of_squares = std::numeric_limits<double>::infinity();
  const double noise = noise_of(curve_);
  for (const YieldSamples& samples : starts) {
    CurveSolution begun = begin_with(samples);
    const std::vector<std::size_t> looked = yields();
    if (std::any_of(looked.begin(), looked.end(), [&](std::size_t which) {
          return begun.yield_ticks[which] && !(yield_value(begun.values, which, *begun.yield_ticks[which]) > 0.0);
        })) {
      continue;
    }
    CurveSolution solution = settle(std::move(begun), first_steps);
    if (solution.sum_of_squares < best.sum_of_squares) best = std::move(solution);
    if (several && best.sum_of_squares < explained * noise * noise * static_cast<double>(rows_.size())) break;
  }
  return improve(std::move(best));
}

std::vector<YieldCandidate> CurveSolver::alternatives(const CurveSolution& solution, std::size_t which,
                                                      double allowed, bool& bounded) const {
  std::vector<YieldCandidate> found;
  bounded = true;
  if (!solution.yield_ticks[which]) return found;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> slope(sensitivity(solution, smooth()));
  for (const int direction : {-1, 1}) {
    int misses = 0;
    for (std::size_t n = 1; misses < 2; ++n) {
      const std::optional<std::size_t> tick = neighbouring_tick(*solution.yield_ticks[which], direction, n);
      if (!tick || n > farthest) {
        bounded = false;
        break;
      }
      if (!(yield_value(solution.values, which, *tick) > 0.0)) break;
      YieldCandidate other = candidate(*tick, residuals_with(solution, which, *tick), slope);
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
      found.push_back(settle(std::move(begun), model_.yields.size() > 1 ? steps_of_many : all_steps));
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
                                            std::size_t which, std::size_t tick) const {
  Eigen::VectorXd gradient(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double step = 1e-6 * scale_of(parameters[i], solution.values);
    std::vector<double> up = solution.values, down = solution.values;
    up[parameters[i]] += step;
    down[parameters[i]] -= step;
    gradient(static_cast<Eigen::Index>(i)) =
        (yield_value(up, which, tick) - yield_value(down, which, tick)) / (2.0 * step);
  }
  return gradient;
}

}  // namespace bodkin::study
