#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry.h"
#include "core/rotation.h"

namespace bodkin::forces {

// kappa = tan(phi)/l1, 1/mm: the bicycle form; phi steering angle, rad; l1 wheel base, mm.
double bevel_curvature(double angle, double base);

// A needle as a beam on an elastic foundation (Winkler) with a force across its tip.
struct WinklerTip {
  double beta;        // 1/mm, (k_f / (4 E I))^(1/4)
  double deflection;  // y0, mm, 2 P beta / k_f
};
// `rigidity`: E I, N mm^2; `foundation`: k_f, N/mm^2; `load`: P, N.
WinklerTip winkler_tip(double rigidity, double foundation, double load);

// The path of a bevelled needle (Webster et al. 2006, unicycle): its tip bends with a fixed curvature towards the
// bevel.
//
//   advance ds with shaft roll dphi:  T <- T exp([kappa ds ex + dphi ez, ds ez])      exactly on SE(3)
//
// T tip frame, ez the needle's axis, ex the axis about which it bends; kappa 1/mm, a property of needle and tissue, 0
// for a symmetric tip. Withdrawal retraces the path that was cut; only beyond its end is new tissue cut.
class BevelTip {
 public:
  // `curvature`: 0 to 0.1 1/mm. `longest`: mm of path that is remembered, 1 to 1000; at its end the needle stops.
  // Throws InputError outside these ranges. Allocates all memory here.
  BevelTip(double curvature, double longest);

  // Puts the tip at `start` with no path cut.
  void begin(const Pose& start) noexcept;
  // Moves by `advance` mm along the path (negative: back, at most to the start) and rolls the shaft by `roll` rad.
  // Input that is not finite has no effect.
  const Pose& step(double advance, double roll) noexcept;

  const Pose& tip() const noexcept { return tip_; }
  double length() const noexcept { return length_; }  // mm of path from the start to the tip
  double cut() const noexcept { return cut_; }        // mm of path that has been cut

 private:
  struct Node {
    Pose pose = Pose::Identity();
    double roll = 0.0;  // of the shaft when this was cut, rad
  };
  static constexpr double spacing = 0.25;  // mm between nodes

  // The way from one node to the next, as if the shaft had not been turned. A tick rarely goes on to the next.
  struct Segment {
    Vec3 from = Vec3::Zero(), way = Vec3::Zero();
    Arc turn;
    double length = 0.0;  // in units of `spacing`
  };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Pose on_path(double length) noexcept;
  Segment segment_after(std::size_t node) const noexcept;

  double curvature_, longest_;
  std::vector<Node> nodes_;  // at multiples of `spacing`
  std::size_t known_ = 0;
  Node end_;  // of the cut path
  Segment segment_;
  std::size_t segment_after_ = none;  // the node at which segment_ begins
  Pose tip_ = Pose::Identity();
  double roll_ = 0.0, length_ = 0.0, cut_ = 0.0;
};

}  // namespace bodkin::forces
