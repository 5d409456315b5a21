#pragma once

#include <cstdint>

#include "core/geometry.h"

namespace bodkin::haptics {

// An oscillation that was detected.
struct Oscillation {
  double frequency = 0.0;  // Hz
  double width = 0.0;      // mm from side to side on the axis on which it is widest; of a rotation: of a lever's end
  bool turns = false;      // the tool rotates to and fro
};

// Reduces the force on an oscillating hand, step by step until it is calm: half the stiffness; a quarter of it, with
// damping; no force. Each step lasts 25 ms, or 50 if a slow hand is just reversing, so that an oscillation that
// nothing stops has lost its force within 100 ms. After ten calm seconds the hand gets its force back within one
// more. All functions are noexcept.
class ForceReduction {
 public:
  enum class Step : std::uint8_t { none, softer, damped, none_left };

  // An oscillation was detected. Returns the step taken.
  Step begin(const Oscillation& oscillation) noexcept;
  // A tick: mm by which the hand, and the end of the lever on which rotations are measured, moved since the last one,
  // `dt` s ago. The kind of the oscillation determines which of the two is used. Returns the next step if one is
  // taken.
  Step step(const Vec3& moved, const Vec3& turned, double dt) noexcept;
  void reset() noexcept { *this = ForceReduction(); }

  bool is_on() const noexcept { return share_ < 1.0; }
  bool is_watching() const noexcept { return watching_; }  // the next step depends on the hand's present motion
  double share() const noexcept { return share_; }         // fraction of the force that is passed on
  bool damps() const noexcept { return damps_; }
  const Oscillation& oscillation() const noexcept { return oscillation_; }

 private:
  // The range of the hand's positions, mm.
  struct Reach {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    void add(const Vec3& place) noexcept;
    double most() const noexcept { return (high - low).maxCoeff(); }  // of an axis
  };

  void watch_anew() noexcept;

  double share_ = 1.0;
  bool damps_ = false;
  bool watching_ = false;
  Oscillation oscillation_;
  double since_ = 0.0;         // s since the last step
  double for_ = 0.0;           // s in the window
  Vec3 place_ = Vec3::Zero();  // mm from the position at the last step
  Reach window_, all_;         // in the window, and since the last step
};

}  // namespace bodkin::haptics
