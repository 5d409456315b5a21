#pragma once

#include "anatomy/tissue.h"
#include "core/geometry.h"
#include "forces/syringe.h"

namespace bodkin::station {

// The syringe on the needle as felt by a hand on a haptic device: down is in.
//
//   x = z0 - z,  s = clamp(x, 0, 60 mm)   travel from where the hand was when it was armed
//   force upwards = syringe(ds/dt, tissue at the tip)   0 < x      (forces/syringe.h)
//                 + k (x - 60 mm)                       x > 60 mm  (the barrel is empty)
//   force sideways = 0.2 N/mm towards the vertical through the start, at most 1 N
//
// k: 1 N/mm, or what the device renders stably if that is less. A barrel of saline of area A and compliance C is a
// spring of A^2/C = 312 N/mm, more than any device renders, so C is increased to A^2/k; the plunger's friction, which
// acts as damping below 1 mm/s, is reduced to the damping that the device renders. The pressure is the integral of
// the inflow, so the travel of each tick is passed to the syringe as it is: an estimate of the speed would make that
// spring lag, and a spring that lags pushes harder outwards than inwards.
class Plunger {
 public:
  // `dt`: s of a tick, 0.00025 to 0.005. `stiffness`, `damping`: rendered stably by the device, N/mm (> 0) and N s/mm
  // (>= 0). Throws InputError as Syringe does.
  Plunger(const anatomy::TissueLibrary& library, double dt, double stiffness, double damping);

  // The force on the hand (N) at `hand` (mm), both in the operator's frame. While disarmed the hand feels no force
  // and moves the start with it; rearming refills the syringe.
  Vec3 step(const Vec3& hand, anatomy::TissueId tissue, bool armed) noexcept;

  double travel() const noexcept { return travel_; }                      // mm, 0 to barrel_length
  double force() const noexcept { return force_; }                        // N upwards, of the last step
  double pressure() const noexcept { return syringe_.state().pressure; }  // MPa gauge
  double volume() const noexcept { return syringe_.area() * travel_; }    // mm^3 expelled from the barrel
  double stiffness() const noexcept { return stiffness_; }                // N/mm, k

  static constexpr double barrel_length = 60.0;  // mm

 private:
  double dt_, stiffness_;
  forces::Syringe syringe_;
  Vec3 start_ = Vec3::Zero();
  double travel_ = 0.0;
  double force_ = 0.0;
};

}  // namespace bodkin::station
