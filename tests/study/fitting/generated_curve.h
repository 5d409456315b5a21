#pragma once

#include <string>
#include <vector>

#include "study/fitting/fit.h"

#include "core/random.h"

namespace bodkin {

using namespace bodkin::study;

// A stretch of a needle's motion at constant speed; a rest if the speed is 0.
struct Stretch {
  double speed = 0.0;     // mm/s, negative: out
  double duration = 0.0;  // s
};

// The noise-free readings of a sensor at `rate` (Hz) on a model with known values, beginning 0.5 mm before the skin.
inline MeasuredCurve generated_curve(const std::string& model, const std::vector<double>& values,
                                     const std::vector<Stretch>& way, double rate = 100.0) {
  MeasuredCurve curve;
  curve.name = model + ".csv";
  double depth = -0.4931, time = 0.0, left = 0.0;
  const double step = 1.0 / rate;
  for (const Stretch& stretch : way) {
    for (left += stretch.duration; left > 1e-9; left -= step) {
      curve.time.push_back(time);
      curve.depth.push_back(depth);
      time += step;
      depth += stretch.speed * step;
    }
  }
  const NeedleHistory history = needle_history(curve.time, curve.depth, 0.0);
  std::vector<double> force(history.ticks.size());
  fit_model(model).simulate(values, history, force);
  curve.force.resize(curve.size());
  at_samples(history, force, curve.force);
  return curve;
}

inline MeasuredCurve with_noise(MeasuredCurve curve, double deviation, std::uint64_t seed) {
  Random random(seed);
  for (double& force : curve.force) force += deviation * random.normal();
  return curve;
}

}  // namespace bodkin
