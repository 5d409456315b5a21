#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/tissue.h"

namespace bodkin::views {

// The force of one insertion along the planned path, for a chart.
struct ForceCurve {
  struct Point {
    double depth, force;  // mm, N along the needle, positive pushes out
  };
  struct Band {
    double from, to;  // mm
    anatomy::TissueId tissue;
  };
  std::vector<Point> points;
  std::vector<Band> bands;
  double strongest = 0.0;                      // N
  std::optional<double> first_puncture_force;  // N, puncture force of the first layer
  double milliseconds = 0.0;                   // to compute it
  std::string trouble;                         // why there is no curve: a sentence; empty: there is one
};

}  // namespace bodkin::views
