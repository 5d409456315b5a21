#pragma once

#include <span>
#include <string>
#include <vector>

#include "study/fitting/fit.h"

namespace bodkin::study {

// The puncture force of one curve's needle.
struct PunctureOfNeedle {
  std::string curve;      // name of the file
  double diameter = 0.0;  // mm, outer, of the needle
  double force = 0.0;     // N
};

// F = F_ref (d / d_ref)^n, by least squares of the logarithms. n is 1 if the force is proportional to the perimeter
// of the cut, 2 if to the needle's cross-section.
struct GaugeLaw {
  std::vector<PunctureOfNeedle> points;  // by diameter
  double reference = 0.0;                // mm, d_ref: the geometric mean of the diameters
  double force = 0.0;                    // N, F_ref
  double exponent = 0.0;                 // n
  // The 95 % interval of each; of zero width with only two curves, which cannot determine it.
  double force_low = 0.0, force_high = 0.0;
  double exponent_low = 0.0, exponent_high = 0.0;
  bool has_intervals = false;

  double at(double diameter) const;  // N
};

// The parameter of a fit that is the puncture force: break_force of `layered`, puncture_force of `three_component`.
// Throws InputError for other models and for a curve without a puncture.
double puncture_force_of(const CurveFit& fit, const std::string& curve);

// At least two curves, at least two diameters (mm, above 0), forces above 0 N; throws InputError otherwise.
GaugeLaw fit_gauge_law(std::span<const PunctureOfNeedle> points);

}  // namespace bodkin::study
