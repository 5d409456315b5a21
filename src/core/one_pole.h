#pragma once

#include <cmath>
#include <numbers>

#include "core/repeatable.h"

namespace bodkin {

// First-order low pass in discrete time, y += a (x - y), a = 1 - exp(-2 pi fc T): exact for an input that is constant
// between two ticks. Use it for velocities and stiffnesses, never in the path of a force: its lag costs stability (a
// filter of 30 Hz needs eleven times the damping at 1 N/mm).
class OnePole {
 public:
  // `cutoff`: Hz, > 0. `dt`: s, > 0.
  OnePole(double cutoff, double dt) : gain_(1.0 - repeatable::exp(-2.0 * std::numbers::pi * cutoff * dt)) {}

  double step(double input) noexcept { return value_ += gain_ * (input - value_); }
  double value() const noexcept { return value_; }
  double gain() const noexcept { return gain_; }
  void reset(double value = 0.0) noexcept { value_ = value; }

 private:
  double gain_;
  double value_ = 0.0;
};

}  // namespace bodkin
