#pragma once

#include "anatomy/force_settings.h"
#include "anatomy/needle.h"
#include "core/geometry.h"
#include "core/one_pole.h"
#include "forces/constraint_model.h"

namespace bodkin::forces {

// Bending stiffness of a tube, N mm^2: E pi/64 (D^4 - d^4). Diameters mm, modulus MPa.
double bending_stiffness(double modulus, double outer_diameter, double inner_diameter);

// The needle outside the body bends like a rod clamped in the skin (Sutherland et al. 2013, eq. 4):
//
//   F_hand = -(3 E I / L_out^3) d        |F_hand| <= limit
//
// L_out length outside, mm; d displacement of the hub across the frozen line, mm. The stiffness diverges as L_out
// goes to 0; L_out is therefore never taken shorter than the length at which it equals the device's largest
// stiffness. Small deflections: good to |d| < L_out / 10. It acts at the hub. The stiffness depends on depth while
// nothing acts along the needle, as printed, so it can give energy on closed paths: **active**, see
// docs/models/beam.md.
class Beam {
 public:
  using Settings = anatomy::BeamSettings;

  // Throws InputError for settings or a needle out of range. `dt`: s, 1e-6 to 0.1.
  Beam(const anatomy::BeamSettings& settings, const anatomy::Needle& needle, double dt);
  // From a patient: also refuses settings that the device cannot render stably.
  Beam(const anatomy::Case& patient, const anatomy::BeamSettings& settings, double dt);

  // Clamps the needle at `entry` along the unit vector `direction`: call it at the puncture. `tip`: where it is now.
  void begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept;
  // Force on the hand at the hub, LPS N. Zero for input that is not finite.
  Vec3 step(const Vec3& tip, const Vec3& axis) noexcept;
  Wrench step(const ConstraintInput& needle) noexcept { return from_hub(step(needle.tip, needle.axis), needle); }

  // 3 E I / L^3 with the guard against short lengths, N/mm.
  double stiffness(double outside) const noexcept;
  double shortest() const noexcept { return shortest_; }

 private:
  double length_, limit_, rigidity_, shortest_;  // mm, N, N mm^2, mm
  OnePole outside_;                              // L_out, mm
  Vec3 entry_ = Vec3::Zero();
  Vec3 direction_ = Vec3::UnitZ();
};

}  // namespace bodkin::forces
