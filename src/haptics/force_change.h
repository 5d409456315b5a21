#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry.h"

namespace bodkin::haptics {

// Limits on the change and the size of a force from tick to tick, used by ForceGovernor and HandGuard. Pure
// functions, for forces (N) and torques (N mm) alike.

struct ForceChange {
  Vec3 value;
  bool limited;
};

// From `last` towards `wanted`: the part of the change that shortens the last value is unlimited, the rest is at most
// `most`. So the drop of a puncture is not slowed, only rises and turns are.
inline ForceChange approach(const Vec3& last, const Vec3& wanted, double most) noexcept {
  const double square = last.squaredNorm();
  const double kept = square > 0.0 ? std::clamp(wanted.dot(last) / square, 0.0, 1.0) : 0.0;
  const Vec3 start = kept * last;
  const Vec3 change = wanted - start;
  const double size = change.norm();
  if (size <= most) return {wanted, false};
  return {start + change * (most / size), true};
}

// `force` made no larger than `size`, in the same direction. A limit that is only touched by rounding cannot be felt,
// and does not count as `limited`.
inline ForceChange shortened(const Vec3& force, double size) noexcept {
  const double norm = force.norm();
  if (norm <= size) return {force, false};
  return {force * (size / norm), norm > size * (1.0 + 1e-9)};
}

// The largest force that the motors' heat allows, N, for a mean square of the past forces (N^2): the peak while they
// are cool, the continuous force once their mean load is used up, a straight line in between from 80 % of the load
// on. The mean square converges to the square of the continuous force and never exceeds it, and the force has no
// step.
inline double thermal_bound(double mean_square, double continuous_force, double peak_force) noexcept {
  constexpr double knee = 0.8;  // of the continuous load
  const double load = mean_square / (continuous_force * continuous_force);
  const double spent = std::clamp((load - knee) / (1.0 - knee), 0.0, 1.0);
  return peak_force + spent * (continuous_force - peak_force);
}

}  // namespace bodkin::haptics
