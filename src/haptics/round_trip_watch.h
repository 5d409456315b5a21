#pragma once

#include "core/geometry.h"

namespace bodkin::haptics {

// Sees a hand that a force drives to and fro unevenly: from 3 Hz on, however the swings differ in width and length.
//
// OscillationWatch adds up what the force gives from one turning point to the next but one; when the swings differ,
// energy that the tissue stores at the wider one hides it. Here the sum ends where it began: when the hand passes the
// same place in the same direction. A force that depends on the place alone has then given nothing, whichever law it
// follows and however wide the swing was; one that is computed every T from the place gives K T/2 times the time
// integral of the squared speed (Colgate and Schenkel 1994). A force that gives more in every such round trip, for
// 600 ms and three of them at least, drives the hand. The place is the middle of the last swings; it moves on
// when the hand no longer passes it. step() is noexcept and allocates nothing.
class RoundTripWatch {
 public:
  // `swing`: mm that the hand goes to either side at least; `gain`: N s/mm as ShakingPattern::gain.
  RoundTripWatch(double swing, double gain) noexcept : swing_(swing), gain_(gain) {}

  // As OscillationWatch::step().
  bool step(const Vec3& moved, const Vec3& force, double dt) noexcept;
  void reset() noexcept { *this = RoundTripWatch(swing_, gain_); }

  // Of the round trip that ended last: Hz; mm from side to side along the axis of the operator's frame on which it
  // was widest.
  double frequency() const noexcept { return frequency_; }
  double width() const noexcept { return width_; }

 private:
  bool passes(double before) const noexcept;
  void begin(double given, double way, double time) noexcept;

  double swing_, gain_;
  Vec3 axis_ = Vec3::Zero();  // unit, along the force, of either sign; zero: nothing has pushed yet
  double unpushed_ = 0.0;     // s without force
  double place_ = 0.0;        // mm along the axis
  double passed_ = 0.0;       // mm: where round trips begin and end
  bool begun_ = false;
  double low_ = 0.0, high_ = 0.0;                // mm, in this round trip
  double given_ = 0.0, way_ = 0.0, time_ = 0.0;  // N mm, mm^2/s, s, in this round trip
  double lasting_ = 0.0;                         // s of round trips in which the force has driven
  int trips_ = 0;                                // of them
  double frequency_ = 0.0, width_ = 0.0;
};

}  // namespace bodkin::haptics
