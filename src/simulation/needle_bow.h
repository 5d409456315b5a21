#pragma once

#include "anatomy/case.h"
#include "core/axial_motion.h"
#include "forces/events.h"

namespace bodkin::simulation {

// A needle that is pushed harder than it bears bows to the side between the hand and the skin, and its tip stops:
//
//   P_out = pi^2 E I / (0.7 l)^2     Euler, hub clamped, held across by the skin; l mm of needle outside the body
//   P_in  = 2 sqrt(k E I)            on the tissue beside the shaft (Hetenyi 1946); k = Young's modulus of
//                                    the softest tissue passed, N/mm per mm
//
// At P = min(P_out, P_in) the shaft yields at a constant force, as a buckled column does; further motion of the hand
// becomes bow. When the tissue resists less, the needle straightens and its tip advances; when the hand comes back,
// the bow is reduced first. The stored energy, P times the bow, comes from the hand: passive.
class NeedleBow {
 public:
  // With mechanics="tables" the needle is rigid.
  NeedleBow(const anatomy::Case& patient, double dt);

  void begin() noexcept;
  // The motion of the tip for a motion of the hand along the line.
  AxialMotion tip_motion(const AxialMotion& hand) noexcept;
  // N of the tissue's resistance that reach the hand. `tissue`: at the tip. Appends needle_buckled, value N, when the
  // needle begins to bow.
  double limited(double resistance, anatomy::TissueId tissue, forces::TickEvents& events) noexcept;
  // mm by which the tip is behind that of a straight needle.
  double bow() const noexcept { return bow_; }

 private:
  double strength() const noexcept;  // N, P
  // Whether a force is P or more. Needs no division for most forces.
  bool bows_under(double force) const noexcept;

  bool rigid_;
  double length_, stiffness_, of_clamped_;     // mm; N mm^2, E I; pi^2 E I
  double straightening_;                       // mm per tick
  std::array<double, 256> young_{};            // MPa, 256, by TissueId; 0: unknown
  double softest_ = 0.0;                       // MPa, of the tissues passed
  double on_support_ = 0.0;                    // N, P_in of these tissues; unused where softest_ is 0
  double hand_ = 0.0, tip_ = 0.0, bow_ = 0.0;  // mm
  double last_ = 0.0;                          // N, of the last tick
  bool fresh_ = true, over_ = false;
};

}  // namespace bodkin::simulation
