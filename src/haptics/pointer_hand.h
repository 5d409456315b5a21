#pragma once

#include "core/geometry.h"

namespace bodkin::haptics {

// What a mouse and a keyboard have done since a window was opened: plain numbers that a loop reads whole. Counts only
// grow or shrink by what happened, so a state that was not read in time loses nothing.
struct PointerState {
  double right = 0.0, away = 0.0;           // pixels that the pointer went, away: up on the screen
  double pushed = 0.0;                      // steps of the wheel, forwards
  double tilted_right = 0.0, tilted = 0.0;  // pixels of a drag that turns the needle; away from the operator
  Vec3 keys = Vec3::Zero();                 // now held, -1 to 1: to the right, away, inwards
  double tilt_key = 0.0;                    // now held, -1 to 1: the tip away from the operator
  double share = 1.0;                       // of the speed of the keys: fine_share while the motion is fine
  bool ended = false;                       // the window is closed
};

inline constexpr double fine_share = 0.2;

// Events of a mouse and a keyboard, added up.
class PointerInput {
 public:
  // Keys that move the needle while they are held.
  enum class Key { right, left, away, near, inwards, outwards, tilt_away, tilt_near };

  // The pointer went so many pixels; turning: it turns the needle instead.
  void move(double right, double away, bool turning) noexcept;
  void wheel(double steps) noexcept { state_.pushed += state_.share * steps; }
  void key(Key key, bool down) noexcept;
  // No key is held any more: the window has lost the keyboard.
  void release() noexcept;
  void fine(bool on) noexcept { state_.share = on ? fine_share : 1.0; }
  void end() noexcept { state_.ended = true; }

  const PointerState& state() const noexcept { return state_; }

 private:
  PointerState state_;
  bool down_[8] = {};
};

struct PointerSettings {
  double pixel = 0.1;        // mm per pixel
  double step = 1.0;         // mm per step of the wheel
  double speed = 10.0;       // mm/s of a key that is held
  double turn = 0.002;       // rad per pixel of a drag
  double turn_speed = 0.2;   // rad/s of a key that is held
  double smoothing = 0.050;  // s, the time constant T
  double reach = 150.0;      // mm from the middle along each axis
};

// The hand that a mouse and a keyboard mean, operator's frame. It begins in the middle of the workspace, the needle
// pointing down; inwards is along the needle, down while it is not tilted. What comes in steps becomes a motion by
//
//   T^2 x'' + 2 T x' + x = goal        critically damped: no overshoot, 90 % of a step after 3.9 T
//
// solved exactly for a goal that stands still during dt, for the position and for the two angles. Tilts are at most
// 60 degrees. Nothing here allocates.
class PointerHand {
 public:
  explicit PointerHand(const PointerSettings& settings) : settings_(settings) {}

  // The hand `dt` s after the last step. The first step takes the counts as they are for zero.
  const Pose& step(const PointerState& state, double dt) noexcept;
  const Vec3& velocity() const noexcept { return velocity_; }  // mm/s

 private:
  PointerSettings settings_;
  PointerState last_;
  bool begun_ = false;
  Vec3 goal_ = Vec3::Zero(), position_ = Vec3::Zero(), velocity_ = Vec3::Zero();
  Vec3 tilt_goal_ = Vec3::Zero(), tilt_ = Vec3::Zero(), tilt_rate_ = Vec3::Zero();  // rad: to the right, away, none
  Pose hand_ = Pose::Identity();
};

}  // namespace bodkin::haptics
