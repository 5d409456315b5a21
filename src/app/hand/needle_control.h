#pragma once

#include <optional>
#include <string>

#include "app/hand/aim.h"
#include "app/hand/mouse_hand.h"

#include "anatomy/needle_path.h"

namespace bodkin::app {

// What mouse and keys do to the needle, as a HandWish: aim, put down, push, draw back, tilt, hold, withdraw. One
// rule: a needle in tissue moves along its axis only.
class NeedleControl {
 public:
  static constexpr double notch = 0.5, fine_notch = 0.1;          // mm of the wheel
  static constexpr double key_speed = 5.0, fine_key_speed = 1.0;  // mm/s
  static constexpr double withdrawing = 20.0;                     // mm/s
  static constexpr double turn_speed = 180.0 * degree;            // rad/s
  static constexpr double lead = 8.0;  // mm that the hand may be ahead of a needle that does not follow

  // A new attempt with this plan, whose entry is where the needle goes down when nothing else was aimed at. `entry`:
  // without a plan.
  void begin(const std::optional<anatomy::NeedlePath>& plan, const SkinPoint& entry);

  // The pointer is over the skin; ignored while the needle is down.
  void aim(const SkinPoint& skin);
  // The tip goes to the skin.
  void put_down();
  // By the wheel. From above the skin the first notch inwards brings the tip to the skin. `fine`: by small steps,
  // with the hand braced against the patient, until it goes on by large ones.
  void push(double notches, bool fine);
  // mm, by a drag of the hub.
  void drag(double millimetres);
  // Keys that are held: -1 out, 0, +1 in.
  void hold_key(int direction, bool fine);
  // Keys that are held: the needle is turned about its axis, +1 clockwise for who looks along it, 0 not, -1 back.
  void hold_turn(int direction) { turn_key_ = direction; }
  bool is_turning() const noexcept { return turn_key_ != 0; }
  // Turns the needle about the point where it goes in, rad. False, and nothing done, when it is too deep for that.
  bool tilt(double right, double cranial);
  // Out, to 5 mm above the skin; any push stops it.
  void withdraw();
  void hold(bool on);
  void end() { wish_.ended = true; }

  // Once a frame: `dt` s since the last one, and what the hand has come to.
  void update(double dt, const HandReport& hand);

  const HandWish& wish() const noexcept { return wish_; }
  bool is_down() const noexcept { return wish_.is_down; }
  bool is_held() const noexcept { return held_; }
  // Where the needle is drawn while it is not down: its tip on the skin.
  Pose hovering() const { return turned_needle(wish_.at, wish_.axis, wish_.turn); }

 private:
  void move(double millimetres);
  void brace(bool on);

  std::optional<anatomy::NeedlePath> plan_;
  HandWish wish_;
  HandReport hand_;
  int key_ = 0, turn_key_ = 0;
  bool fine_ = false, held_ = false, withdrawing_ = false;
};

}  // namespace bodkin::app
