#pragma once

#include "core/geometry.h"

namespace bodkin {

// Sees a hand that a force shakes: turning points of the motion along the force's direction that follow each other
// faster than 60 a second (30 Hz) for 100 ms, each swing larger than `amplitude`. A hand's own tremor is 8 to 12 Hz
// and is none. step() is noexcept and allocates nothing.
class OscillationWatch {
 public:
  // `amplitude`: mm from turning point to turning point, > 0.
  explicit OscillationWatch(double amplitude) noexcept : amplitude_(amplitude) {}

  // `moved`: mm since the last tick; `force`: N that the hand was pushed with. True at the tick at which a shaking
  // has lasted 100 ms, and every 100 ms that it goes on.
  bool step(const Vec3& moved, const Vec3& force, double dt) noexcept;
  void reset() noexcept { *this = OscillationWatch(amplitude_); }

 private:
  double amplitude_;
  Vec3 axis_ = Vec3::Zero();  // unit, along the force, of either sign; zero: nothing has pushed yet
  double unpushed_ = 0.0;     // s without force
  double place_ = 0.0;        // mm along the axis
  double extreme_ = 0.0;      // mm, the furthest since the last turning point
  bool forwards_ = true;
  double since_turn_ = 0.0;  // s
  double shaking_ = 0.0;     // s
};

}  // namespace bodkin
