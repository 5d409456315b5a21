#pragma once

#include "anatomy/part_settings.h"

namespace bodkin::forces {

struct CsfState {
  double height = 0.0;     // mm of fluid in the manometer
  double flow = 0.0;       // mm^3/s, into the manometer or dripping
  double collected = 0.0;  // mm^3 that have dripped out
};

// The fluid that returns through a spinal needle whose tip is in cerebrospinal fluid:
//
//   manometer   h <- h_eq + (h - h_eq) exp(-dt/tau),   tau = R A/(rho g),   R = 128 mu L/(pi d^4)
//   free drip   Q = rho g h_eq / R
//
// Lost fluid lowers the pressure (Marmarou, Shulman, Rosende 1978), if the settings have an index PVI:
//
//   h_eq = h_0 10^(-V/PVI)
//
// A bevel that lies across the dura is only partly open: R is multiplied by 1/open. A stylet stops all flow.
class CsfFlow {
 public:
  // Throws InputError for a setting outside its range. `dt`: s, 1e-6 to 0.1.
  CsfFlow(const anatomy::CsfFlowSettings& settings, double dt);

  // `open`: fraction of the opening that is in fluid, 0 to 1 (clamped; NaN = 0). No flow when 0 or with the stylet
  // in.
  const CsfState& step_manometer(double open, bool stylet) noexcept;
  const CsfState& step_drip(double open, bool stylet) noexcept;
  // Removes the manometer; its content is added to the collected fluid.
  void empty_manometer() noexcept;
  void reset() noexcept { state_ = {}; }

  double pressure() const noexcept;  // h_eq, mm of fluid

  double resistance() const noexcept { return resistance_; }  // R, MPa s/mm^3
  double drip(double height) const noexcept;                  // Q at `height` mm, mm^3/s
  double time_constant() const noexcept;  // tau of the manometer, s, whether or not it is connected

 private:
  double section() const noexcept;             // of the manometer, mm^2
  double faded_in_tick(double part) noexcept;  // exp(-dt part/tau) - 1

  anatomy::CsfFlowSettings settings_;
  double dt_;  // s of fluid time: times_faster ticks
  double resistance_;
  double faded_for_ = 0.0, faded_ = 0.0;  // the part open in the last tick, and what it gave
  CsfState state_;
};

}  // namespace bodkin::forces
