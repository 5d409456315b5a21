#include "study/fitting/needle_history.h"

#include <algorithm>
#include <cmath>

#include "core/motion_estimator.h"

namespace bodkin::study {

NeedleHistory needle_history(std::span<const double> times, std::span<const double> depths, double resolution) {
  NeedleHistory history;
  const double begin = times.front();
  const auto ticks = static_cast<std::size_t>(std::ceil((times.back() - begin) / history.dt - 1e-9)) + 1;
  history.ticks.reserve(ticks);
  MotionEstimator estimator(history.dt, resolution);
  std::size_t next = 1;  // the sample at or after the tick
  for (std::size_t n = 0; n < ticks; ++n) {
    const double time = std::min(begin + static_cast<double>(n) * history.dt, times.back());
    while (next + 1 < times.size() && times[next] < time) ++next;
    const double width = times[next] - times[next - 1];
    const double share = width > 0.0 ? std::clamp((time - times[next - 1]) / width, 0.0, 1.0) : 1.0;
    history.ticks.push_back(estimator.step(depths[next - 1] + share * (depths[next] - depths[next - 1])));
  }
  history.places.reserve(times.size());
  for (const double time : times) {
    const double place = (time - begin) / history.dt;
    const double whole = std::round(place);
    history.places.push_back(std::abs(place - whole) < 1e-6 ? whole : place);
  }
  return history;
}

void at_samples(const NeedleHistory& history, std::span<const double> force, std::span<double> sampled) {
  for (std::size_t i = 0; i < sampled.size(); ++i) {
    const auto before = static_cast<std::size_t>(history.places[i]);
    const double share = history.places[i] - static_cast<double>(before);
    sampled[i] = share > 0.0 ? force[before] + share * (force[before + 1] - force[before]) : force[before];
  }
}

}  // namespace bodkin::study
