#pragma once

#include "core/geometry.h"

namespace bodkin::haptics {

// Which shaking is looked for.
struct ShakingPattern {
  double swing = 0.05;              // mm from turning point to turning point, at least
  double half_period = 1.0 / 60.0;  // s from turning point to turning point, at most
  double lasting = 0.1;             // s
  // N s/mm: with every cycle the force gives the hand more than this times the time integral of its speed squared,
  // what its mean gives apart.
  // Negative: what the force gives does not matter.
  double gain = -1.0;
};

// Faster than any hand, its tremor (8 to 12 Hz) included: above 30 Hz for 100 ms.
ShakingPattern fast_shaking(double swing) noexcept;

// An unstable wall against a soft hand bounces at 12 to 25 Hz, because the slew and the peak of the force bound it; a
// trembling hand comes near that. The criterion is who does the work. A wall of stiffness K, computed every
// T, leaks K T/2 of negative damping (Colgate and Schenkel 1994), and a device that renders K stably swallows that; a
// force that gives more, cycle after cycle, drives the hand. Above 10 Hz for 250 ms.
ShakingPattern driven_shaking(double swing, double device_stiffness, double dt) noexcept;

// The same, slower than that: above 3 Hz for 600 ms.
ShakingPattern slow_shaking(double swing, double device_stiffness, double dt) noexcept;

// Sees a hand that a force shakes, from the turning points of its motion along the force's direction. step() is
// noexcept and allocates nothing.
class OscillationWatch {
 public:
  explicit OscillationWatch(const ShakingPattern& pattern) noexcept : pattern_(pattern) {}

  // `moved`: mm since the last tick; `force`: N that the hand was pushed with meanwhile. True at the tick at which
  // the shaking has lasted long enough, and again after every such time while it continues.
  bool step(const Vec3& moved, const Vec3& force, double dt) noexcept;
  void reset() noexcept { *this = OscillationWatch(pattern_); }

  // Of the cycle that ended last: Hz, 0 before the first; mm from side to side along the axis of the operator's frame
  // on which it was widest.
  double frequency() const noexcept { return frequency_; }
  double width() const noexcept { return width_; }

 private:
  bool is_driven(double turned_at) const noexcept;

  ShakingPattern pattern_;
  Vec3 axis_ = Vec3::Zero();  // unit, along the force, of either sign; zero: nothing has pushed yet
  double unpushed_ = 0.0;     // s without force
  double place_ = 0.0;        // mm along the axis
  double extreme_ = 0.0;      // mm, the furthest since the last turning point
  bool forwards_ = true;
  double since_turn_ = 0.0;                  // s
  double turn_took_ = 0.0;                   // s between the last two turning points
  double frequency_ = 0.0, width_ = 0.0;     // Hz, mm
  double shaking_ = 0.0;                     // s
  double turn_ = 0.0, turn_before_ = 0.0;    // mm, the last two turning points
  double given_ = 0.0, given_before_ = 0.0;  // N mm since the last turning point, and between the last two
  double way_ = 0.0, way_before_ = 0.0;      // mm^2/s, time integral of the squared speed
  Vec3 pushed_ = Vec3::Zero(), pushed_before_ = Vec3::Zero();  // N s
  Vec3 gone_ = Vec3::Zero(), gone_before_ = Vec3::Zero();      // mm
};

}  // namespace bodkin::haptics
