#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "anatomy/force_settings.h"

namespace bodkin::forces {

// Stress relaxation: filters an elastic force F0 so that a held deformation loses part of it with time.
//
//   F = g_inf F0 + sum h_i;   h_i <- e_i h_i + g_i (tau_i/dt)(1 - e_i)(F0 - F0 of the last tick)
//   e_i = exp(-dt/tau_i)
//
// g_inf = 1 - sum g_i. Exact for F0 that is linear between ticks, stable for any dt, passive for g_i >= 0 and linear
// springs. The physical counterpart of the catch-up of `tracking_wall`: after a stop the force falls to g_inf, not to
// zero.
class PronyRelaxation {
 public:
  static constexpr std::size_t capacity = 4;

  // Throws InputError for more than four terms, values out of range or shares whose sum exceeds 1.
  PronyRelaxation(std::span<const anatomy::PronyTerm> terms, double dt);

  // F of this tick. An F0 that is not finite gives 0 and changes nothing.
  double step(double elastic) noexcept;
  void reset() noexcept;
  double remaining() const noexcept { return rest_; }  // g_inf

 private:
  std::size_t count_ = 0;
  double rest_ = 1.0;                                       // g_inf
  double last_ = 0.0;                                       // F0, N
  std::array<double, capacity> decay_{}, gain_{}, part_{};  // capacity: e_i; g_i tau_i/dt (1 - e_i); h_i, N
};

}  // namespace bodkin::forces
