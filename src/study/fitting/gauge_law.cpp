#include "study/fitting/gauge_law.h"

#include <algorithm>
#include <cmath>

#include "study/fitting/least_squares.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::study {

namespace {

constexpr double outside_interval = 0.05;  // 1 - confidence
constexpr double same_diameter = 1e-6;     // of logarithms

}  // namespace

double GaugeLaw::at(double diameter) const {
  return force * std::pow(diameter / reference, exponent);
}

double puncture_force_of(const CurveFit& fit, const std::string& curve) {
  const FittedParameter* force = fit.find("break_force");
  if (force == nullptr) force = fit.find("puncture_force");
  if (force == nullptr) {
    throw InputError(fmt::format(
        "--needles: {} has no force of puncture; expected layered or three_component, which have one", fit.model));
  }
  if (force->status == ParameterStatus::not_identified)
    throw InputError(fmt::format("--needles: nothing gives way in {}; leave out that curve", curve));
  return force->value;
}

GaugeLaw fit_gauge_law(std::span<const PunctureOfNeedle> points) {
  GaugeLaw law;
  law.points.assign(points.begin(), points.end());
  std::sort(law.points.begin(), law.points.end(),
            [](const PunctureOfNeedle& a, const PunctureOfNeedle& b) { return a.diameter < b.diameter; });
  double x = 0.0, y = 0.0;
  for (const PunctureOfNeedle& one : law.points) {
    if (!(one.diameter > 0.0 && one.force > 0.0))
      throw InputError(fmt::format("{}: the needle is {:g} mm thick and punctures at {:g} N, expected both above 0",
                                   one.curve, one.diameter, one.force));
    x += std::log(one.diameter) / static_cast<double>(points.size());
    y += std::log(one.force) / static_cast<double>(points.size());
  }
  double xx = 0.0, xy = 0.0;
  for (const PunctureOfNeedle& one : law.points) {
    const double away = std::log(one.diameter) - x;
    xx += away * away;
    xy += away * (std::log(one.force) - y);
  }
  if (!(xx > same_diameter))
    throw InputError("--needles: all curves are of one diameter; expected at least two for a law of force and gauge");
  law.reference = std::exp(x);
  law.force = law.force_low = law.force_high = std::exp(y);
  law.exponent = law.exponent_low = law.exponent_high = xy / xx;
  if (points.size() < 3) return law;
  double left = 0.0;
  for (const PunctureOfNeedle& one : law.points) {
    const double residual = std::log(one.force) - std::log(law.at(one.diameter));
    left += residual * residual;
  }
  const std::size_t freedom = points.size() - 2;
  const double deviation = std::sqrt(left / static_cast<double>(freedom));
  const double quantile = joint_quantile(outside_interval, 1, freedom);
  const double of_force = quantile * deviation / std::sqrt(static_cast<double>(points.size()));
  const double of_exponent = quantile * deviation / std::sqrt(xx);
  law.force_low = law.force * std::exp(-of_force);
  law.force_high = law.force * std::exp(of_force);
  law.exponent_low = law.exponent - of_exponent;
  law.exponent_high = law.exponent + of_exponent;
  law.has_intervals = true;
  return law;
}

}  // namespace bodkin::study
