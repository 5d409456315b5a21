#pragma once

#include <Eigen/Core>

#include "anatomy/force_settings.h"

namespace bodkin::fem {

struct NeedleBeamSettings {
  double rigidity = 877.94;  // E I, N mm^2 (bending_stiffness() in forces/beam.h); 0.1 to 1e9, or infinite
                             // [24G tube of steel]
  double length = 90.0;      // mm, hub to tip; 5 to 500
  anatomy::NeedleHold hold = anatomy::NeedleHold::clamped;
  double cut_offset = 0.0;  // mm, of a bevelled needle: lateral offset of the cut from its axis, towards its point;
                            // 0 to 2, 0 = a symmetric point
};

// The piece of a needle between the hub and the surface of the body, as seen from its end at the surface, in one
// plane.
//
//   (y, slope) = root root^T (V, M)      V N, M N mm at the surface; y mm, slope rad
struct ShaftRoot {
  double outside = 0.0;                                                    // mm, hub to surface
  Eigen::Matrix<double, 2, 3> root = Eigen::Matrix<double, 2, 3>::Zero();  // by rows: y, slope
};

// A uniform needle as an Euler-Bernoulli beam, straight without loads, its tip free.
//
//   d^2/dx^2 (E I d^2 w/dx^2) = load across;   w = w' = 0 where it is clamped, or w = 0 where it is pinned
//
// Between point loads its deflection is a cubic, which a cubic Hermite element represents exactly: a chain of such
// elements with a node at every load gives the same result as the formulas here, which need no equations to be
// solved. Deflections small against the length, no shear (a needle is slender), no buckling by the axial force. The
// plane does not matter: the section is round. Theory: any book on strength of materials; docs/flexible-needle.md.
class NeedleBeam {
 public:
  // Throws InputError for settings out of range.
  explicit NeedleBeam(const NeedleBeamSettings& settings);

  const NeedleBeamSettings& settings() const noexcept { return settings_; }

  // mm/N, across: displacement at one of two points by a force at the other, both >= 0 mm from the clamped end.
  //
  //   w = n^2 (3 m - n) / (6 E I)      n the lesser, m the greater
  double flexibility(double a, double b) const noexcept;

  // For a tip `depth` mm beyond the surface. A hub inside the body is treated as being at its surface.
  ShaftRoot root(double depth) const noexcept;

  // N, along the needle, that push the hand back because a bent needle gets shorter outside as it goes in: the
  // derivative of its energy with respect to depth. `force` N across at the surface and `moment` N mm at the hub,
  // both in one plane and by the needle on the tissue; `turn` rad, by which a pinned hub is turned.
  double push_back(const ShaftRoot& root, double force, double moment, double turn) const noexcept;

  // 1/(N mm): rotation of the hub in the hand per moment. 0 when it is clamped.
  double turning() const noexcept { return turning_; }

 private:
  NeedleBeamSettings settings_;
  double compliance_ = 0.0;  // 1/(E I)
  double turning_ = 0.0;
};

}  // namespace bodkin::fem
