#pragma once

#include "core/geometry.h"

namespace bodkin::imaging {

// Where at rest that was which now is at `place`: the X with X + displacement(X) = place, LPS mm, found by iteration
// to a fiftieth of the displacement. `displacement`: of a place at rest, mm.
template <typename Displacement>
Vec3 rest_place(const Vec3& place, const Displacement& displacement) {
  constexpr int iterations = 8;
  constexpr double settled = 1e-3;  // mm
  Vec3 rest = place;
  for (int i = 0; i < iterations; ++i) {
    // Half steps: where tissue is stretched by more than its length whole ones would not settle.
    const Vec3 next = 0.5 * rest + 0.5 * (place - displacement(rest));
    const bool is_there = (next - rest).squaredNorm() < settled * settled;
    rest = next;
    if (is_there) break;
  }
  return rest;
}

}  // namespace bodkin::imaging
