#include "study/fitting/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "study/fitting/curve_shape.h"
#include "study/fitting/curve_solver.h"
#include <fmt/format.h>

#include "core/error.h"
#include "core/settings_check.h"

namespace bodkin::study {

namespace {

constexpr double alpha = 0.05;               // 1 - confidence
constexpr double flat = 1e-3;                // singular values below this share are noise
constexpr double less_by = 1.0 - 1e-4;       // of the sum of squares: a better place, ...
constexpr double less_of_many = 1.0 - 1e-3;  // ... where several yields make the search long
constexpr std::size_t samples_to_spare = 5;  // samples in excess of the parameters
constexpr double usual_speed = 10.0;         // mm/s, where the speed does not matter
constexpr double alike = 0.3;                // correlation of neighbouring residuals that is worth a note
constexpr double late_contact = 1.0;         // mm between contact and the first force that is worth a note

std::size_t place_of(const FitModel& model, const std::string& name) {
  for (std::size_t i = 0; i < model.parameters.size(); ++i)
    if (model.parameters[i].name == name) return i;
  std::string names;
  for (const FitParameter& one : model.parameters) names += fmt::format("{}{}", names.empty() ? "" : ", ", one.name);
  throw InputError(fmt::format("{} has no parameter {}, expected one of {}", model.name, io::in_quotes(name), names));
}

double within_range(const FitModel& model, std::size_t place, double value, const char* option) {
  const FitParameter& one = model.parameters[place];
  check_range(option, one.name, value, {one.low, one.high}, one.unit);
  return value;
}

// The user's requests for the parameters.
void apply(const FitRequest& request, const FitModel& model, CurveSolver& solver) {
  for (const FitParameter& one : model.parameters) {
    solver.looked_for.push_back(one.fitted);
    solver.low.push_back(one.low);
    solver.high.push_back(one.high);
    solver.kept.push_back(one.usual);
    solver.start.emplace_back();
  }
  for (const std::string& name : request.free) solver.looked_for[place_of(model, name)] = true;
  for (const ParameterBounds& one : request.bounds) {
    const std::size_t place = place_of(model, one.name);
    solver.low[place] = within_range(model, place, one.low, "--bounds");
    solver.high[place] = within_range(model, place, one.high, "--bounds");
    if (!(one.low < one.high))
      throw InputError(fmt::format("--bounds: {} reaches from {:g} to {:g}, expected a lower value first", one.name,
                                   one.low, one.high));
    solver.kept[place] = std::clamp(solver.kept[place], one.low, one.high);
  }
  for (const auto& [name, value] : request.start) {
    const std::size_t place = place_of(model, name);
    solver.start[place] = solver.kept[place] = within_range(model, place, value, "--start");
  }
  for (const auto& [name, value] : request.fix) {
    const std::size_t place = place_of(model, name);
    solver.kept[place] = within_range(model, place, value, "--fix");
    solver.looked_for[place] = false;
  }
}

NeedleHistory history_of(const MeasuredCurve& curve, const FitRequest& request, const FitModel& model) {
  std::optional<double> speed = request.speed;
  if (!speed && !model.needs_time) speed = usual_speed;
  if (speed) check_range("", "--speed", *speed, {0.01, 1000.0}, "mm/s");
  check_range("", "--resolution", request.resolution, {0.0, 1.0}, "mm");
  return needle_history(sample_times(curve, speed), curve.depth, request.resolution);
}

std::vector<bool> counting(const MeasuredCurve& curve, const FitRequest& request) {
  if (!(request.from < request.to))
    throw InputError(
        fmt::format("--from {:g} --to {:g} mm holds no depth; give a smaller depth first", request.from, request.to));
  std::vector<bool> counts(curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i)
    counts[i] = curve.depth[i] >= request.from && curve.depth[i] <= request.to;
  return counts;
}

// Of a stack of `tracking_wall`: each layer's force begins with the median measured in its deeper half on the way in.
// A force that is never reached gives no slope.
void begin_layers(const MeasuredCurve& curve, const FitModel& model, FitRequest& request) {
  if (request.model != "tracking_wall") return;
  constexpr double least = 0.01;  // N, if the middle of a layer has no samples
  const double deepest = *std::max_element(curve.depth.begin(), curve.depth.end());
  for (std::size_t layer = 0; layer < request.layers.size(); ++layer) {
    const std::string name = fmt::format("force_{}", layer + 1);
    const bool given = std::any_of(request.start.begin(), request.start.end(),
                                   [&](const NamedValue& one) { return one.first == name; });
    const double top = request.layers[layer],
                 end = layer + 1 < request.layers.size() ? std::min(request.layers[layer + 1], deepest) : deepest;
    std::vector<double> forces;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const bool inside = curve.depth[i] > 0.5 * (top + end) && curve.depth[i] <= end;
      if (inside && curve.depth[i] > curve.depth[i - 1]) forces.push_back(curve.force[i]);
    }
    if (given || forces.empty()) continue;
    const auto middle = forces.begin() + static_cast<std::ptrdiff_t>(forces.size() / 2);
    std::nth_element(forces.begin(), middle, forces.end());
    request.start.emplace_back(name, std::clamp(*middle, least, model.parameters[place_of(model, name)].high));
  }
}

// Fits, drops the undetermined parameters, and estimates the uncertainty of the rest.
class Estimation {
 public:
  Estimation(const FitModel& model, CurveSolver& solver) : model_(model), solver_(solver) {
    for (const FitParameter& one : model.parameters) {
      FittedParameter parameter;
      parameter.name = one.name;
      parameter.unit = one.unit;
      parameters_.push_back(std::move(parameter));
    }
  }

  void run() {
    solution_ = solver_.solve();
    for (const std::size_t which : solver_.yields())
      if (!solution_.yield_ticks[which]) give_up_yield(which);
    while (true) {
      find_active();
      const Eigen::MatrixXd slope = solver_.sensitivity(solution_, active_);
      std::vector<double> scale;
      for (const std::size_t i : active_) scale.push_back(solver_.scale_of(i, solution_.values));
      const Degeneracy degeneracy = flattest_direction(slope, scale, flat);
      if (degeneracy.found) {
        give_up(degeneracy);
        continue;
      }
      if (!find_intervals(slope)) continue;
      break;
    }
    for (std::size_t i = 0; i < parameters_.size(); ++i) parameters_[i].value = solution_.values[i];
  }

  const CurveSolution& solution() const noexcept { return solution_; }
  std::vector<FittedParameter>& parameters() noexcept { return parameters_; }

 private:
  // Smooth fitted parameters that lie within their bounds.
  void find_active() {
    active_.clear();
    for (const std::size_t i : solver_.smooth()) {
      const double close = 1e-7 * solver_.scale_of(i, solution_.values);
      const bool low = solution_.values[i] <= solver_.low[i] + close;
      const bool high = solution_.values[i] >= solver_.high[i] - close;
      parameters_[i].status = low || high ? ParameterStatus::at_bound : ParameterStatus::estimated;
      parameters_[i].remark = low    ? "the best value is the lowest allowed"
                              : high ? "the best value is the highest allowed"
                                     : "";
      if (!low && !high) active_.push_back(i);
    }
  }

  void keep(std::size_t parameter, std::string remark) {
    parameters_[parameter].status = ParameterStatus::not_identified;
    parameters_[parameter].remark = std::move(remark);
    solver_.looked_for[parameter] = false;
    solution_.values[parameter] = solver_.kept[parameter];
  }

  void give_up(const Degeneracy& degeneracy) {
    const std::size_t last = active_[degeneracy.parameters.back()];
    if (degeneracy.parameters.size() == 1) {
      keep(last, "the data do not depend on it");
    } else {
      std::string others;
      for (std::size_t i = 0; i + 1 < degeneracy.parameters.size(); ++i)
        others += (i > 0 ? ", " : "") + model_.parameters[active_[degeneracy.parameters[i]]].name;
      keep(last, "the data do not distinguish it from " + others);
    }
    solution_ = solver_.improve(std::move(solution_));
  }

  void give_up_yield(std::size_t which) {
    const std::size_t yield = model_.yields[which];
    double most = 0.0;
    for (std::size_t n = 0; n < solver_.history().ticks.size(); ++n)
      most = std::max(most, solver_.yield_value(solution_.values, which, n));
    solver_.kept[yield] =
        std::clamp(std::max(solver_.kept[yield], 1.01 * most), solver_.low[yield], solver_.high[yield]);
    keep(yield, fmt::format("nothing gives way in the data; it is more than {:.4g} {}", most,
                            model_.parameters[yield].unit));
  }

  // False if a parameter proved undetermined and the rest must be fitted again.
  bool find_intervals(const Eigen::MatrixXd& slope) {
    const std::vector<std::size_t> yields = solver_.yields();
    const std::size_t estimated = active_.size() + yields.size();
    if (estimated == 0) return true;
    const std::size_t freedom = solver_.counted() - estimated;
    const double variance = solution_.sum_of_squares / static_cast<double>(freedom);
    const double quantile = joint_quantile(alpha, estimated, freedom);
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(0, 0);
    if (!active_.empty()) covariance = variance * inverse_normal_matrix(slope);
    const double allowed = solution_.sum_of_squares + quantile * quantile * variance;
    std::vector<double> errors;
    for (Eigen::Index i = 0; i < covariance.rows(); ++i) errors.push_back(std::sqrt(covariance(i, i)));
    const std::vector<CurveSolution> around = solver_.neighbours(solution_, active_, errors);
    for (const CurveSolution& other : around) {
      if (other.sum_of_squares >= (model_.yields.size() > 1 ? less_of_many : less_by) * solution_.sum_of_squares)
        continue;
      solution_ = solver_.improve(other);
      return false;
    }
    std::vector<std::vector<YieldCandidate>> others;  // for each yield
    std::vector<bool> bounded;
    for (const std::size_t which : yields) {
      bool ends = true;
      others.push_back(solver_.alternatives(solution_, which, allowed, ends));
      bounded.push_back(ends);
    }
    smooth_intervals(covariance, quantile, others);
    for (const CurveSolution& other : around) {
      if (other.sum_of_squares > allowed) continue;
      for (const std::size_t i : active_) {
        const double error = quantile * parameters_[i].standard_error;
        parameters_[i].low = std::clamp(other.values[i] - error, solver_.low[i], parameters_[i].low);
        parameters_[i].high = std::clamp(other.values[i] + error, parameters_[i].high, solver_.high[i]);
      }
    }
    for (std::size_t i = 0; i < yields.size(); ++i)
      yield_interval(yields[i], covariance, quantile, others[i], bounded[i]);
    for (auto i = active_.rbegin(); i != active_.rend(); ++i) {
      const FittedParameter& one = parameters_[*i];
      if (one.high - one.low <= solver_.high[*i] - solver_.low[*i]) continue;
      keep(*i, "the data allow its whole range");
      solution_ = solver_.improve(std::move(solution_));
      return false;
    }
    return true;
  }

  void smooth_intervals(const Eigen::MatrixXd& covariance, double quantile,
                        const std::vector<std::vector<YieldCandidate>>& others) {
    const std::vector<std::size_t> smooth = solver_.smooth();
    for (std::size_t a = 0; a < active_.size(); ++a) {
      const auto row = static_cast<Eigen::Index>(a);
      FittedParameter& one = parameters_[active_[a]];
      one.standard_error = std::sqrt(covariance(row, row));
      const auto place =
          static_cast<std::size_t>(std::find(smooth.begin(), smooth.end(), active_[a]) - smooth.begin());
      double down = 0.0, up = 0.0;  // effect of other places of the yields
      for (const std::vector<YieldCandidate>& of_one : others) {
        double lowest = 0.0, highest = 0.0;
        for (const YieldCandidate& other : of_one) {
          lowest = std::min(lowest, other.shift[place]);
          highest = std::max(highest, other.shift[place]);
        }
        down += lowest;
        up += highest;
      }
      const double value = solution_.values[active_[a]];
      one.low = std::max(solver_.low[active_[a]], value + down - quantile * one.standard_error);
      one.high = std::min(solver_.high[active_[a]], value + up + quantile * one.standard_error);
    }
  }

  // The value at the last tick before the yield does not suffice, that at the yield's tick does.
  void yield_interval(std::size_t which, const Eigen::MatrixXd& covariance, double quantile,
                      const std::vector<YieldCandidate>& others, bool bounded) {
    const std::size_t yield = model_.yields[which];
    FittedParameter& one = parameters_[yield];
    const std::vector<std::size_t> smooth = solver_.smooth();
    const auto error_at = [&](std::size_t tick) {
      if (active_.empty()) return 0.0;
      const Eigen::VectorXd gradient = solver_.yield_gradient(solution_, active_, which, tick);
      return std::sqrt(std::max(0.0, gradient.dot(covariance * gradient)));
    };
    const auto include = [&](std::size_t tick, const std::vector<double>& shift) {
      std::vector<double> values = solution_.values;
      for (std::size_t i = 0; i < shift.size(); ++i) values[smooth[i]] += shift[i];
      const double reach = quantile * error_at(tick);
      const std::size_t step = std::min(tick, solver_.grid_step());
      one.low = std::min(one.low, solver_.yield_value(values, which, tick - step) - reach);
      one.high = std::max(one.high, solver_.yield_value(values, which, tick) + reach);
      if (solver_.grid_step() > 1 && tick + step < solver_.history().ticks.size())
        one.high = std::max(one.high, solver_.yield_value(values, which, tick + step - 1) + reach);
    };
    const std::size_t tick = *solution_.yield_ticks[which];
    one.status = ParameterStatus::estimated;
    one.remark.clear();
    one.low = one.high = solution_.values[yield];
    one.standard_error = error_at(tick);
    include(tick, {});
    for (const YieldCandidate& other : others) include(other.tick, other.shift);
    one.low = std::max(one.low, solver_.low[yield]);
    one.high = std::min(one.high, solver_.high[yield]);
    if (!bounded) one.remark = "the data hardly determine where the tissue gives way";
  }

  const FitModel& model_;
  CurveSolver& solver_;
  std::vector<FittedParameter> parameters_;
  CurveSolution solution_;
  std::vector<std::size_t> active_;
};

void describe_quality(const MeasuredCurve& curve, const std::vector<bool>& counts, CurveFit& fit) {
  double mean = 0.0, total = 0.0, left = 0.0, neighbours = 0.0, last = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (counts[i]) mean += curve.force[i] / static_cast<double>(fit.samples);
  bool begun = false;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!counts[i]) continue;
    const double residual = curve.force[i] - fit.force[i];
    total += (curve.force[i] - mean) * (curve.force[i] - mean);
    left += residual * residual;
    if (begun) neighbours += residual * last;
    last = residual;
    begun = true;
  }
  const auto samples = static_cast<double>(fit.samples);
  const double rounding = 1e-9 * std::max(std::abs(mean), 1e-3);  // N
  fit.r_squared =
      total > samples * rounding * rounding ? 1.0 - left / total : std::numeric_limits<double>::quiet_NaN();
  fit.rmse = std::sqrt(left / samples);
  const auto found = std::count_if(fit.parameters.begin(), fit.parameters.end(), [](const FittedParameter& one) {
    return one.status == ParameterStatus::estimated || one.status == ParameterStatus::at_bound;
  });
  const double free = static_cast<double>(found) + 1.0;  // the noise is estimated too
  fit.aic = samples * std::log(std::max(left / samples, rounding * rounding)) + 2.0 * free +
            2.0 * free * (free + 1.0) / std::max(1.0, samples - free - 1.0);
  const double correlation = left > 0.0 ? neighbours / left : 0.0;
  if (correlation > alike) {
    fit.notes.push_back(
        fmt::format("neighbouring residuals are alike (correlation {:.2f}): the model misses something that the data "
                    "have, and the intervals, which take residuals as independent, are too narrow",
                    correlation));
  }
}

void remark_on_motion(const NeedleHistory& history, CurveFit& fit) {
  std::size_t moving = 0, unseen = 0;
  for (std::size_t n = 1; n < history.ticks.size(); ++n) {
    if (history.ticks[n].depth == history.ticks[n - 1].depth) continue;
    ++moving;
    unseen += history.ticks[n].direction == 0 ? 1 : 0;
  }
  if (2 * unseen > moving) {
    fit.notes.emplace_back(
        "the needle moves so slowly that the simulator takes it to be at rest most of the time; give the time of the "
        "samples in seconds, or measure faster");
  }
}

}  // namespace

const FittedParameter* CurveFit::find(std::string_view name) const noexcept {
  for (const FittedParameter& one : parameters)
    if (one.name == name) return &one;
  return nullptr;
}

CurveFit fit_curve(const MeasuredCurve& curve, const FitRequest& request) {
  return fit_curves({&curve, 1}, request);
}

CurveFit fit_curves(std::span<const MeasuredCurve> curves, const FitRequest& asked) {
  if (curves.empty()) throw InputError("there is no curve to fit");
  FitRequest request = asked;
  const FitModel model = request.layers.empty() ? fit_model(request.model) : fit_stack(request.model, request.layers);
  const MeasuredCurve curve = joined(curves);
  begin_layers(curve, model, request);
  const std::vector<bool> counts = counting(curve, request);
  std::vector<NeedleHistory> histories;
  for (const MeasuredCurve& one : curves) histories.push_back(history_of(one, request, model));
  CurveSolver solver(model, curve, std::move(histories), counts);
  apply(request, model, solver);
  const auto wanted = static_cast<std::size_t>(std::count(solver.looked_for.begin(), solver.looked_for.end(), true));
  if (solver.counted() < wanted + samples_to_spare) {
    throw InputError(
        fmt::format("{}: {} samples between --from and --to are too few for {} parameters, expected at least {}",
                    curve.name, solver.counted(), wanted, wanted + samples_to_spare));
  }
  Estimation estimation(model, solver);
  estimation.run();

  CurveFit fit;
  fit.model = model.name;
  for (const MeasuredCurve& one : curves) {
    if (!one.assumed.empty()) fit.notes.push_back(one.assumed);
  }
  fit.parameters = estimation.parameters();
  fit.samples = solver.counted();
  fit.force = solver.force_at_samples(estimation.solution().values);
  for (const std::optional<std::size_t>& tick : estimation.solution().yield_ticks)
    if (tick) fit.yields_at.push_back(solver.history().ticks[*tick].depth);
  fit.elements = model.elements(estimation.solution().values);
  describe_quality(curve, counts, fit);
  remark_on_motion(solver.history(), fit);
  if (model.contact && !fit.parameters[*model.contact].standard_error) {
    const double contact = fit.parameters[*model.contact].value, first = contact_of(curve);
    if (first > contact + late_contact &&
        first > contact + 0.1 * (*std::max_element(curve.depth.begin(), curve.depth.end()) - contact)) {
      fit.notes.push_back(
          fmt::format("the force begins at {:.2f} mm, but depth should count from where the needle meets the tissue; "
                      "give --start "
                      "contact={:.2f}, or --free contact to fit it",
                      first, first));
    }
  }
  return fit;
}

ModelChoice choose_model(std::span<const MeasuredCurve> curves, const FitRequest& request) {
  ModelChoice choice;
  if (!request.layers.empty()) fit_stack("tracking_wall", request.layers);  // wrong depths are refused for all models
  for (const FitModel& model : fit_models()) {
    FitRequest one = request;
    one.model = model.name;
    if (model.stack == nullptr) one.layers.clear();
    try {
      choice.fits.push_back(fit_curves(curves, one));
    } catch (const InputError& error) {
      choice.refused.emplace_back(model.name, error.what());
    }
  }
  if (choice.fits.empty()) throw InputError(choice.refused.front().second);
  std::stable_sort(choice.fits.begin(), choice.fits.end(),
                   [](const CurveFit& a, const CurveFit& b) { return a.aic < b.aic; });
  return choice;
}

}  // namespace bodkin::study
