#pragma once

#include "core/geometry.h"

namespace bodkin::haptics {

// Detects a hand that is driven to and fro unevenly by a force: from 3 Hz on, however the swings differ in width and
// length.
//
// OscillationWatch sums the energy from the force from one turning point to the next but one; when the swings differ,
// energy that the tissue stores at the wider one hides it. Here the sum ends where it began: when the hand passes the
// same position in the same direction. A force that depends only on position has then given no energy, whichever law
// it follows and however wide the swing was; one that is computed every T from the position gives K T/2 times the
// time integral of the squared speed (Colgate and Schenkel 1994). A force that gives more in every such round trip,
// for at least 600 ms and three of them, drives the hand. The position is the middle of the last swings; it is moved
// when the hand no longer passes it. step() is noexcept and allocates nothing.
class RoundTripWatch {
 public:
  // `swing`: mm, least motion to either side; `gain`: N s/mm as OscillationPattern::gain.
  RoundTripWatch(double swing, double gain) noexcept : swing_(swing), gain_(gain) {}

  // As OscillationWatch::step().
  bool step(const Vec3& moved, const Vec3& force, double dt) noexcept;
  void reset() noexcept { *this = RoundTripWatch(swing_, gain_); }

  // Of the last complete round trip: Hz; mm from side to side along the axis of the operator's frame on which it was
  // widest.
  double frequency() const noexcept { return frequency_; }
  double width() const noexcept { return width_; }

 private:
  bool passes(double before) const noexcept;
  void begin(double work, double speed_integral, double time) noexcept;

  double swing_, gain_;
  Vec3 axis_ = Vec3::Zero();  // unit, along the force, of either sign; zero: no force yet
  double unpushed_ = 0.0;     // s without force
  double place_ = 0.0;        // mm along the axis
  double passed_ = 0.0;       // mm: where round trips begin and end
  bool begun_ = false;
  double low_ = 0.0, high_ = 0.0;                          // mm, in this round trip
  double work_ = 0.0, speed_integral_ = 0.0, time_ = 0.0;  // N mm, mm^2/s, s, in this round trip
  double lasting_ = 0.0;                                   // s of consecutive round trips driven by the force
  int trips_ = 0;                                          // their number
  double frequency_ = 0.0, width_ = 0.0;
};

}  // namespace bodkin::haptics
