#pragma once

#include <algorithm>

namespace bodkin::forces {

// A constant cutting force at the tip, without the jumps of a sign function: a stiff spring whose far end W follows
// the tip once the force is reached, and never comes back. The channel up to W is cut and free.
//
//   W = max(W, x - f/K);   F = K max(0, x - W)
//
// x depth, mm; f cutting force, N; K spring, N/mm. Passive: the stored f^2/(2K) is only released.
class CuttingEdge {
 public:
  CuttingEdge() = default;
  // `force`: N, >= 0. `stiffness`: N/mm, > 0.
  CuttingEdge(double force, double stiffness) : force_(force), stiffness_(stiffness) {}

  // Treats everything above `depth` as cut.
  void start(double depth) noexcept { wall_ = depth; }
  double step(double depth) noexcept {
    wall_ = std::max(wall_, depth - force_ / stiffness_);
    return stiffness_ * std::max(0.0, depth - wall_);
  }
  double reach() const noexcept { return force_ / stiffness_; }  // mm
  double wall() const noexcept { return wall_; }                 // W, mm

 private:
  double force_ = 0.0;
  double stiffness_ = 1.0;
  double wall_ = 0.0;
};

}  // namespace bodkin::forces
