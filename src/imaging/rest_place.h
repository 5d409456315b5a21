#pragma once

#include "core/geometry.h"

namespace bodkin::imaging {

// The position at rest of the point that is now at `place`: the X with X + displacement(X) = place, LPS mm, found by
// iteration to a fiftieth of the displacement. `displacement`: of a point at rest, mm.
template <typename Displacement>
Vec3 rest_place(const Vec3& place, const Displacement& displacement) {
  constexpr int iterations = 8;
  constexpr double settled = 1e-3;  // mm
  Vec3 rest = place;
  for (int i = 0; i < iterations; ++i) {
    // Half steps: whole ones would not converge in tissue stretched by more than its length.
    const Vec3 next = 0.5 * rest + 0.5 * (place - displacement(rest));
    const bool is_there = (next - rest).squaredNorm() < settled * settled;
    rest = next;
    if (is_there) break;
  }
  return rest;
}

}  // namespace bodkin::imaging
