#include "forces/voigt_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/repeatable.h"

namespace bodkin::forces {

double VoigtLaw::elastic(double x) const noexcept {
  const double a = x / dx_;
  if (sum_ == VoigtSum::cubic) return k_ * dx_ * a * (a + 1.0) * (a + 2.0) / 6.0;  // eq. 2
  const double n = std::floor(a) + 1.0;
  return k_ * (n * x - dx_ * n * (n - 1.0) / 2.0);
}

double VoigtLaw::tangent(double x) const noexcept {
  const double a = x / dx_;
  if (sum_ == VoigtSum::cubic) return k_ * (3.0 * a * a + 6.0 * a + 2.0) / 6.0;
  return k_ * (std::floor(a) + 1.0);
}

double VoigtLaw::damping(double x) const noexcept {
  const double a = x / dx_;
  return rho_ * (sum_ == VoigtSum::cubic ? a : std::floor(a) + 1.0);
}

double VoigtLaw::inverse(double force) const noexcept {
  if (!(force > 0.0)) return 0.0;
  if (sum_ == VoigtSum::piecewise) {
    const double full =
        std::floor((std::sqrt(1.0 + 8.0 * force / (k_ * dx_)) - 1.0) / 2.0);  // elements at full length
    const double n = full + 1.0;
    return (force / k_ + dx_ * n * (n - 1.0) / 2.0) / n;
  }
  // b^3 - b = c with b = a + 1, by the hyperbolic or the trigonometric root (Vieta).
  const double c = 6.0 * force / (k_ * dx_);
  const double y = 1.5 * std::numbers::sqrt3 * c;
  const double third =
      y >= 1.0 ? repeatable::cosh(repeatable::acosh(y) / 3.0) : repeatable::cos(repeatable::acos(y) / 3.0);
  return (2.0 / std::numbers::sqrt3 * third - 1.0) * dx_;
}

double VoigtLaw::push(double x, double v) const noexcept {
  return x > 0.0 ? std::max(0.0, elastic(x) + damping(x) * v) : 0.0;
}

double VoigtLaw::grip(double x, double v) const noexcept {
  const double size = std::abs(x);
  return std::copysign(elastic(size), x) + damping(size) * v;
}

}  // namespace bodkin::forces
