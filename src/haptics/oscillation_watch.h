#pragma once

#include "core/geometry.h"

namespace bodkin::haptics {

// The oscillation to be detected.
struct OscillationPattern {
  double swing = 0.05;              // mm from turning point to turning point, at least
  double half_period = 1.0 / 60.0;  // s from turning point to turning point, at most
  double lasting = 0.1;             // s
  // N s/mm: in every cycle the force gives the hand more energy than this times the time integral of its squared
  // speed, not counting the work of the mean force. Negative: the energy does not matter.
  double gain = -1.0;
};

// Faster than any hand, including its tremor (8 to 12 Hz): above 30 Hz for 100 ms.
OscillationPattern fast_oscillation(double swing) noexcept;

// An unstable wall against a soft hand bounces at 12 to 25 Hz, because the slew and the peak of the force bound it; a
// trembling hand comes close to that. The criterion is who does the work. A wall of stiffness K, computed every T,
// leaks K T/2 of negative damping (Colgate and Schenkel 1994), which a device that renders K stably absorbs; a force
// that gives more, cycle after cycle, drives the hand. Above 10 Hz for 250 ms.
OscillationPattern driven_oscillation(double swing, double device_stiffness, double dt) noexcept;

// As driven_oscillation(), for slower oscillations: above 3 Hz for 600 ms.
OscillationPattern slow_oscillation(double swing, double device_stiffness, double dt) noexcept;

// Detects a hand that is driven into oscillation by a force, from the turning points of its motion along the force's
// direction. step() is noexcept and allocates nothing.
class OscillationWatch {
 public:
  explicit OscillationWatch(const OscillationPattern& pattern) noexcept : pattern_(pattern) {}

  // `moved`: mm since the last tick; `force`: N on the hand during that time. True at the tick at which the
  // oscillation has lasted long enough, and again after every such period while it continues.
  bool step(const Vec3& moved, const Vec3& force, double dt) noexcept;
  void reset() noexcept { *this = OscillationWatch(pattern_); }

  // Of the last complete cycle: Hz, 0 before the first; mm from side to side along the axis of the operator's frame
  // on which it was widest.
  double frequency() const noexcept { return frequency_; }
  double width() const noexcept { return width_; }

 private:
  bool is_driven(double turned_at) const noexcept;

  OscillationPattern pattern_;
  Vec3 axis_ = Vec3::Zero();  // unit, along the force, of either sign; zero: no force yet
  double unpushed_ = 0.0;     // s without force
  double place_ = 0.0;        // mm along the axis
  double extreme_ = 0.0;      // mm, the furthest since the last turning point
  bool forwards_ = true;
  double since_turn_ = 0.0;                  // s
  double last_half_period_ = 0.0;            // s between the last two turning points
  double frequency_ = 0.0, width_ = 0.0;     // Hz, mm
  double oscillating_ = 0.0;                 // s
  double turn_ = 0.0, previous_turn_ = 0.0;  // mm, the last two turning points
  double work_ = 0.0, previous_work_ = 0.0;  // N mm since the last turning point, and between the last two
  double speed_integral_ = 0.0, previous_speed_integral_ = 0.0;    // mm^2/s, time integral of the squared speed
  Vec3 impulse_ = Vec3::Zero(), previous_impulse_ = Vec3::Zero();  // N s
  Vec3 displacement_ = Vec3::Zero(), previous_displacement_ = Vec3::Zero();  // mm
};

}  // namespace bodkin::haptics
