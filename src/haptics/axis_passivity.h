#pragma once

#include "core/geometry.h"

namespace bodkin::haptics {

// Time-domain passivity at the hand (Hannaford and Ryu 2002), one observer and one controller per axis of the
// operator's frame. Between two ticks a device holds its force, so the energy that the hand has given to an axis is
// known without an error of integration, if every motion is paired with the force that was held during it
// (HeldForce):
//
//   E += -F(held) dx;   if E < -0.1 N mm and |v| > 0.5 mm/s:  alpha = -E / (dt v^2) <= limit,  F_out = F - alpha v
//
//   F force on the hand, N; x position, mm; v velocity, mm/s; E energy, N mm; alpha damping, N s/mm
//
// Less than a tenth of a millijoule can come from one count of an encoder. E restarts from 0 after half a second
// without force, so that old credit hides nothing. PassivityController (haptics/passivity_controller.h), in contrast,
// watches only the tissue along the needle and belongs to the simulation; this class counts everything that the hand
// feels: lateral constraints, scales, holds and a moving body.
class AxisPassivity {
 public:
  // `damping_limit`: N s/mm, what the device can render.
  explicit AxisPassivity(double damping_limit) noexcept : damping_limit_(damping_limit) {}

  // The hand has moved by `moved` (mm) in `dt` (s) under `applied` (N). To be called once per tick, whatever the
  // force.
  void observe(const Vec3& applied, const Vec3& moved, double dt) noexcept;
  // `wanted` (N) with `share` (0 to 1) of the damping that the axes need at `velocity` (mm/s), and of `least` (N
  // s/mm, at most the limit) on every axis in any case.
  Vec3 damped(const Vec3& wanted, const Vec3& velocity, double dt, double share = 1.0, double least = 0.0) noexcept;
  void reset() noexcept;

  const Vec3& energy() const noexcept { return energy_; }    // N mm given by the hand, by axis
  const Vec3& damping() const noexcept { return damping_; }  // N s/mm added by the last damped(), by axis

 private:
  double damping_limit_;
  Vec3 energy_ = Vec3::Zero();
  Vec3 damping_ = Vec3::Zero();
  double time_without_force_ = 0.0;  // s
};

}  // namespace bodkin::haptics
