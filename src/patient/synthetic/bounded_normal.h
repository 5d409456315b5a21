#pragma once

#include <algorithm>

#include "core/random.h"

namespace bodkin::patient {

// Approximately normal with standard deviation 1, between -bound and bound: the sum of six uniform numbers. Only
// exact arithmetic (see shapes.h), so that a seed gives the same patient on every machine.
inline double bounded_normal(Random& random, double bound) {
  double sum = 0.0;
  for (int i = 0; i < 6; ++i) sum += random.uniform(-1.0, 1.0);
  return std::clamp(sum * 0.70710678, -bound, bound);
}

}  // namespace bodkin::patient
