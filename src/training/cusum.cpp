#include "training/cusum.h"

#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::training {

Cusum::Cusum(const CusumSettings& settings) {
  const double p0 = settings.acceptable, p1 = settings.unacceptable;
  if (!(p0 > 0.0 && p0 < p1 && p1 < 1.0)) {
    throw InputError(fmt::format(
        "CUSUM: the acceptable and the unacceptable rate of failure are {} and {}, expected 0 < acceptable < "
        "unacceptable < 1",
        p0, p1));
  }
  for (const double chance : {settings.alpha, settings.beta}) {
    if (!(chance > 0.0 && chance < 0.5))
      throw InputError(fmt::format("CUSUM: a chance of error is {}, expected more than 0 and less than 0.5", chance));
  }
  const double p = std::log(p1 / p0), q = std::log((1.0 - p0) / (1.0 - p1));
  s_ = q / (p + q);
  h0_ = std::log((1.0 - settings.alpha) / settings.beta) / (p + q);
  h1_ = std::log((1.0 - settings.beta) / settings.alpha) / (p + q);
}

std::vector<Cusum::Point> Cusum::curve(std::span<const char> failed) const {
  std::vector<Point> points;
  double value = 0.0, level = 0.0;  // the level at which the present test began
  for (const char each : failed) {
    value += each != 0 ? 1.0 - s_ : -s_;
    Point point{.value = value, .mastery = value <= level - h0_, .failing = value >= level + h1_};
    if (point.mastery || point.failing) level = value;
    points.push_back(point);
  }
  return points;
}

}  // namespace bodkin::training
