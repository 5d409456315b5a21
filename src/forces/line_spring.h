#pragma once

#include "anatomy/case.h"
#include "core/geometry.h"
#include "core/one_pole.h"
#include "forces/constraint_model.h"

namespace bodkin::forces {

// The constraint that keeps a needle on the line on which it touched the body (Heng et al. 2004, eq. 9):
//
//   w = (P - p0) - ((P - p0) . u0) u0        F_hand = -k_c w - b_c dw/dt,  |F_hand| <= limit
//
//   P tip, LPS mm; p0, u0 the line frozen at first contact; w displacement off it, mm; k_c N/mm; b_c N s/mm.
// Eq. 9 prints a magnitude with a minus sign. w is 0 at contact, so the force starts without a step. It acts at the
// tip and knows nothing of depth or rotation. Stiffness and damping are reduced to what the device renders stably
// (core/sampled_stability.h).
class LineSpring {
 public:
  using Settings = anatomy::LineSpringSettings;

  // Throws InputError for values outside the ranges of LineSpringSettings. `device_stiffness`: N/mm, > 0.
  LineSpring(const anatomy::LineSpringSettings& settings, double device_stiffness, double dt);
  LineSpring(const anatomy::Case& patient, const anatomy::LineSpringSettings& settings, double dt)
      : LineSpring(settings, patient.description.device.across(), dt) {}

  // Freezes the line through `entry` along the unit vector `direction`.
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // Force on the hand, N, with the tip at `tip`.
  Vec3 step(const Vec3& tip) noexcept;

  void begin(const Vec3& entry, const Vec3& direction, const Vec3&) noexcept { begin(entry, direction); }
  Wrench step(const ConstraintInput& needle) noexcept { return {step(needle.tip), Vec3::Zero()}; }

  double stiffness() const noexcept { return stiffness_; }
  double damping() const noexcept { return damping_; }

 private:
  double stiffness_, damping_, limit_, dt_, gain_;
  Vec3 entry_ = Vec3::Zero();
  Vec3 direction_ = Vec3::UnitZ();
  Vec3 offset_ = Vec3::Zero();  // w of the previous tick
  Vec3 rate_ = Vec3::Zero();    // dw/dt, low pass of 50 Hz
};

}  // namespace bodkin::forces
