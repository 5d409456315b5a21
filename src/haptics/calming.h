#pragma once

#include <cstdint>

#include "core/geometry.h"

namespace bodkin::haptics {

// What is done about a hand that shakes, step by step until it is calm: half the stiffness; a quarter of it, with
// damping; no force. A step is given 25 ms, so that a shaking that nothing stops has lost its force within 100 ms. A
// hand that has been calm for ten seconds gets its force back within one more. All functions are noexcept.
class Calming {
 public:
  enum class Step : std::uint8_t { none, softer, damped, none_left };

  // The hand shakes at `frequency` (Hz), `width` mm from side to side. Returns the step that is taken.
  Step begin(double frequency, double width) noexcept;
  // A tick: mm moved since the last one, `dt` s ago. Returns the next step where one is taken.
  Step step(const Vec3& moved, double dt) noexcept;
  void reset() noexcept { *this = Calming(); }

  bool is_on() const noexcept { return share_ < 1.0; }
  bool is_watching() const noexcept { return watching_; }  // the next step depends on what the hand does now
  double share() const noexcept { return share_; }         // of the force that is let through
  bool damps() const noexcept { return damps_; }
  double frequency() const noexcept { return frequency_; }  // Hz

 private:
  double share_ = 1.0;
  bool damps_ = false;
  bool watching_ = false;
  double frequency_ = 0.0, width_ = 0.0;
  double since_ = 0.0;                                                    // s since the last step
  double for_ = 0.0;                                                      // s in the window
  Vec3 place_ = Vec3::Zero(), low_ = Vec3::Zero(), high_ = Vec3::Zero();  // mm, in the window
};

}  // namespace bodkin::haptics
