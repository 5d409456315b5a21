#pragma once

namespace bodkin::forces {

// Interpretation of the sum over the elements of the incremental Voigt law.
enum class VoigtSum {
  cubic,     // eq. 2 as printed: E(x) = k dx a (a+1)(a+2)/6, damping a rho
  piecewise  // the text before eq. 2: an equal element joins at every multiple of dx
};

// Incremental viscoelastic law (Brett et al. 1997 after Heng et al. 2004, eq. 1, 2 and 4): with every dx of
// deformation another spring and damper joins in parallel. a = x / dx.
//
//   x   deformation, mm              k    stiffness of an element, N/mm (or N/mm^2 per mm of shaft), > 0
//   v   velocity, mm/s               rho  viscosity of an element, N s/mm (N s/mm^2), >= 0
//   E   elastic force, N (N/mm)      dx   spacing of the elements, mm, > 0
//
// Eq. 2 is not the sum that its derivation describes (cubic against quadratic; they agree at a = 0 and 1). The
// printed polynomial is the default. Eq. 1's minus before rho v contradicts eq. 2 and would feed energy in; plus is
// used.
class VoigtLaw {
 public:
  VoigtLaw() = default;
  VoigtLaw(VoigtSum sum, double stiffness, double viscosity, double spacing)
      : sum_(sum), k_(stiffness), rho_(viscosity), dx_(spacing) {}

  // E(x), x >= 0.
  double elastic(double x) const noexcept;
  // dE/dx, x >= 0.
  double tangent(double x) const noexcept;
  // Coefficient of v, x >= 0: a rho, or the number of elements times rho.
  double damping(double x) const noexcept;
  // The x >= 0 with E(x) = force >= 0, in closed form. Eq. 15 inverts a linear spring instead, which makes the force
  // jump whenever sliding stops.
  double inverse(double force) const noexcept;

  // Eq. 2 for a surface that can push but not hold: max(0, E + damping v); 0 for x < 0.
  double push(double x, double v) const noexcept;
  // Eq. 4, for both signs of x: an odd spring and an even, never negative damper.
  double grip(double x, double v) const noexcept;

  // The same forces over a deformation shorter by `factor`, so a law stiffer by `factor`: E'(x) = E(factor x).
  VoigtLaw softened(double factor) const noexcept { return {sum_, k_ * factor, rho_, dx_ / factor}; }

 private:
  VoigtSum sum_ = VoigtSum::cubic;
  double k_ = 0.0, rho_ = 0.0, dx_ = 1.0;
};

}  // namespace bodkin::forces
