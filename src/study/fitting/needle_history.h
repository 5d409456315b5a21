#pragma once

#include <span>
#include <vector>

#include "core/axial_motion.h"

namespace bodkin::study {

// The motion of a needle as seen by the tick.
struct NeedleHistory {
  double dt = 0.001;               // s
  std::vector<AxialMotion> ticks;  // from the first sample to the last
  std::vector<double> places;      // of the samples, in ticks; fractional between two ticks
};

// Depths (mm) measured at `times` (s, not decreasing), interpolated linearly every millisecond, with velocity,
// direction and rest from the tick's estimator (core/motion_estimator.h). `resolution`: mm, of the measured depth; 0
// = noiseless.
NeedleHistory needle_history(std::span<const double> times, std::span<const double> depths, double resolution);

// A force of every tick, evaluated at the samples; `force` has as many values as `history.ticks`.
void at_samples(const NeedleHistory& history, std::span<const double> force, std::span<double> sampled);

}  // namespace bodkin::study
