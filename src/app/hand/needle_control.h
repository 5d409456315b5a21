#pragma once

#include <optional>
#include <string>

#include "app/hand/aim.h"
#include "app/hand/mouse_hand.h"

#include "anatomy/needle_path.h"

namespace bodkin::app {

// The effect of mouse and keys on the needle, as a HandGoal: aim, put down, push, draw back, tilt, hold, withdraw.
// One rule: a needle in tissue moves only along its axis.
class NeedleControl {
 public:
  static constexpr double notch = 0.5, fine_notch = 0.1;          // mm of the wheel
  static constexpr double key_speed = 5.0, fine_key_speed = 1.0;  // mm/s
  static constexpr double withdrawing = 20.0;                     // mm/s
  static constexpr double turn_speed = 180.0 * degree;            // rad/s
  static constexpr double lead = 8.0;  // mm by which the hand may be ahead of a needle that does not follow

  // A new attempt with this plan, at whose entry the needle is put down unless another point was aimed at. `entry`:
  // without a plan.
  void begin(const std::optional<anatomy::NeedlePath>& plan, const SkinPoint& entry);

  // The pointer is over the skin; ignored while the needle is down.
  void aim(const SkinPoint& skin);
  // Moves the tip to the skin.
  void put_down();
  // By the wheel. From above the skin the first notch inwards brings the tip to the skin. `fine`: in small steps,
  // with the hand braced against the patient, until the next large step.
  void push(double notches, bool fine);
  // mm, by a drag of the hub.
  void drag(double millimetres);
  // Held keys: -1 out, 0, +1 in.
  void hold_key(int direction, bool fine);
  // Held keys: rotates the needle about its axis, +1 clockwise when looking along it, 0 not, -1 back.
  void hold_turn(int direction) { turn_key_ = direction; }
  bool is_turning() const noexcept { return turn_key_ != 0; }
  // Tilts the needle about its entry point, rad. Returns false, without effect, when it is too deep.
  bool tilt(double right, double cranial);
  // Withdraws to 5 mm above the skin; any push stops it.
  void withdraw();
  void hold(bool on);
  void end() { goal_.ended = true; }

  // Once per frame: `dt` s since the last one, and the state of the hand.
  void update(double dt, const HandReport& hand);

  const HandGoal& goal() const noexcept { return goal_; }
  bool is_down() const noexcept { return goal_.is_down; }
  bool is_held() const noexcept { return held_; }
  // The displayed pose of the needle while it is not down: its tip on the skin.
  Pose hovering() const { return turned_needle(goal_.at, goal_.axis, goal_.turn); }

 private:
  void move(double millimetres);
  void brace(bool on);

  std::optional<anatomy::NeedlePath> plan_;
  HandGoal goal_;
  HandReport hand_;
  int key_ = 0, turn_key_ = 0;
  bool fine_ = false, held_ = false, withdrawing_ = false;
};

}  // namespace bodkin::app
