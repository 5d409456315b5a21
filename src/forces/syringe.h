#pragma once

#include <array>

#include "anatomy/part_settings.h"
#include "anatomy/tissue.h"

namespace bodkin::forces {

// R = 128 mu L / (pi d^4), MPa s/mm^3: laminar flow in a tube (Hagen and Poiseuille). mu MPa s (water 1e-9), mm.
double tube_resistance(double viscosity, double length, double bore);

struct SyringeState {
  double pressure = 0.0;  // P, MPa gauge, in the chamber
  double flow = 0.0;      // Q, mm^3/s out of the needle
  double force = 0.0;     // N on the thumb, positive against it; includes the plunger's friction
};

// The loss-of-resistance syringe of epidural anaesthesia (Vaughan et al. 2012; Wee et al. 2017). A thumb pushes the
// plunger at s' mm/s into a chamber of compliance C that empties through needle and tissue:
//
//   C P' = A s' - Q;   Q = (P - P_tissue)/(R_needle + R_tissue);   F = A P + friction
//
// Ligament lets nothing out and P rises; in the epidural space R_tissue collapses: that step is the loss of
// resistance. Solved exactly over a tick with C held, so that the time constant R C may be far below dt:
//   P <- P_inf + (P - P_inf) exp(-dt/(R C)),  P_inf = P_tissue + R A s'
class Syringe {
 public:
  // Throws InputError for a setting outside its range. `dt`: s, 1e-6 to 0.1.
  Syringe(const anatomy::TissueLibrary& library, const anatomy::SyringeSettings& settings, double dt);

  // `plunger_speed`: mm/s inwards; not finite or beyond 1e4: as 0. `tissue`: at the needle's tip.
  const SyringeState& step(double plunger_speed, anatomy::TissueId tissue) noexcept;
  void reset() noexcept { state_ = {}; }
  const SyringeState& state() const noexcept { return state_; }

  // One exact step of the pressure, MPa. `inflow`: A s', mm^3/s; C mm^3/MPa; R MPa s/mm^3, >= 0.
  static double relax(double pressure, double outside, double inflow, double compliance, double resistance,
                      double dt) noexcept;
  double area() const noexcept { return area_; }                            // mm^2
  double needle_resistance() const noexcept { return needle_resistance_; }  // MPa s/mm^3

 private:
  anatomy::SyringeSettings settings_;
  std::array<anatomy::SyringeTissue, 256> tissues_;  // 256, by TissueId of the needle's tip
  double dt_, area_, needle_resistance_;
  SyringeState state_;
};

}  // namespace bodkin::forces
