#pragma once

#include <cstdint>

#include "core/geometry.h"

namespace bodkin::haptics {

// A shaking that was found.
struct Shaking {
  double frequency = 0.0;  // Hz
  double width = 0.0;      // mm from side to side, of the axis on which it is widest; of a turn that of a lever's end
  bool turns = false;      // the tool turns to and fro
};

// What is done about a hand that shakes, step by step until it is calm: half the stiffness; a quarter of it, with
// damping; no force. A step is given 25 ms, or 50 where a slow hand just turns, so that a shaking that nothing stops
// has lost its force within 100 ms. A hand that has been calm for ten seconds gets its force back within one more.
// All functions are noexcept.
class ForceReduction {
 public:
  enum class Step : std::uint8_t { none, softer, damped, none_left };

  // The hand shakes. Returns the step that is taken.
  Step begin(const Shaking& shaking) noexcept;
  // A tick: mm by which the hand, and the end of the lever on which turns are measured, moved since the last one,
  // `dt` s ago. What shook decides which of the two counts. Returns the next step where one is taken.
  Step step(const Vec3& moved, const Vec3& turned, double dt) noexcept;
  void reset() noexcept { *this = ForceReduction(); }

  bool is_on() const noexcept { return share_ < 1.0; }
  bool is_watching() const noexcept { return watching_; }  // the next step depends on what the hand does now
  double share() const noexcept { return share_; }         // of the force that is let through
  bool damps() const noexcept { return damps_; }
  const Shaking& shaking() const noexcept { return shaking_; }

 private:
  // The places where a hand has been, mm.
  struct Reach {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    void add(const Vec3& place) noexcept;
    double most() const noexcept { return (high - low).maxCoeff(); }  // of an axis
  };

  void watch_anew() noexcept;

  double share_ = 1.0;
  bool damps_ = false;
  bool watching_ = false;
  Shaking shaking_;
  double since_ = 0.0;         // s since the last step
  double for_ = 0.0;           // s in the window
  Vec3 place_ = Vec3::Zero();  // mm from where the last step was taken
  Reach window_, all_;         // in the window, and since the last step
};

}  // namespace bodkin::haptics
