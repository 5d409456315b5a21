#pragma once

#include "anatomy/case.h"
#include "core/axial_motion.h"
#include "forces/events.h"

namespace bodkin::simulation {

// A needle that is pushed harder than it bears bows to the side between the hand and the skin, and its tip stays:
//
//   P_out = pi^2 E I / (0.7 l)^2     Euler, hub clamped, held across by the skin; l mm of needle outside the body
//   P_in  = 2 sqrt(k E I)            on the tissue beside the shaft (Hetenyi 1946); k = Young's modulus of the
//   softest
//                                    tissue passed, N/mm per mm
//
// At P = min(P_out, P_in) the shaft gives way at a constant force, as a column does that has buckled; what the hand
// goes on is bow. When the tissue resists less, the needle straightens and its tip goes in; when the hand comes back,
// the bow goes first. What is stored, P times the bow, comes from the hand: passive.
class NeedleBow {
 public:
  // With mechanics="tables" the needle is rigid.
  NeedleBow(const anatomy::Case& patient, double dt);

  void begin() noexcept;
  // The motion of the tip for that of the hand along the line.
  AxialMotion tip_motion(const AxialMotion& hand) noexcept;
  // N that reach the hand of what the tissue resists. `tissue`: at the tip. Appends needle_buckled, value N, when the
  // needle begins to bow.
  double limited(double resistance, anatomy::TissueId tissue, forces::TickEvents& events) noexcept;
  // mm that the tip is behind the place that a straight needle would have.
  double bow() const noexcept { return bow_; }

 private:
  double strength() const noexcept;  // N, P
  // Whether a force is P or more. For most forces that takes no division.
  bool bows_under(double force) const noexcept;

  bool rigid_;
  double length_, stiffness_, of_clamped_;     // mm; N mm^2, E I; pi^2 E I
  double straightening_;                       // mm per tick
  std::array<double, 256> young_{};            // MPa, 256, by TissueId; 0: not known
  double softest_ = 0.0;                       // MPa, of the tissues passed
  double on_support_ = 0.0;                    // N, P_in of them; nothing where softest_ is 0
  double hand_ = 0.0, tip_ = 0.0, bow_ = 0.0;  // mm
  double last_ = 0.0;                          // N, of the last tick
  bool fresh_ = true, over_ = false;
};

}  // namespace bodkin::simulation
