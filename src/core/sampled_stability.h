#pragma once

#include <algorithm>
#include <cmath>

namespace bodkin {

// A virtual wall of stiffness K (N/mm) and damping B (N s/mm), computed every T (s) and held in between, is passive
// for any hand exactly when the device's own damping b exceeds K T/2 + |B| (Colgate and Schenkel 1994). Returns that
// bound, N s/mm.
inline double damping_needed(double stiffness, double damping, double dt) {
  return stiffness * dt / 2.0 + std::abs(damping);
}

// The largest damping, N s/mm, that may be added to a spring of `stiffness` on a device that renders
// `device_stiffness` stably: such a device has at least b = device_stiffness T/2 of its own, and the spring has used
// its part of that.
inline double damping_allowed(double stiffness, double device_stiffness, double dt) {
  return std::max(0.0, (device_stiffness - stiffness) * dt / 2.0);
}

}  // namespace bodkin
