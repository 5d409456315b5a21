#include "app/hand/needle_control.h"

#include <algorithm>

namespace bodkin::app {

namespace {

constexpr double usual_speed = 30.0;          // mm/s
constexpr double touch_depth = 0.3;           // mm beyond the skin, so that the first notch touches it
constexpr double lifted_height = 5.0;         // mm above the skin, where a withdrawn needle ends
constexpr double out_of_skin = -1.0;          // mm
constexpr double straightest = 1.0 * degree;  // within which a tilt snaps to the plan

}  // namespace

void NeedleControl::begin(const std::optional<anatomy::NeedlePath>& plan, const SkinPoint& entry) {
  plan_ = plan;
  goal_ = HandGoal{};
  goal_.at = entry.point;
  goal_.axis = aimed_axis(entry, plan);
  hand_ = HandReport{};
  hand_.depth = -MouseHand::waiting;
  key_ = turn_key_ = 0;
  fine_ = held_ = withdrawing_ = false;
}

void NeedleControl::aim(const SkinPoint& skin) {
  if (goal_.is_down || held_) return;
  goal_.at = skin.point;
  goal_.axis = aimed_axis(skin, plan_);
}

void NeedleControl::put_down() {
  if (goal_.is_down || held_) return;
  goal_.is_down = true;
  goal_.depth = touch_depth;
  goal_.speed = usual_speed;
}

void NeedleControl::move(double millimetres) {
  if (held_) return;
  if (withdrawing_) {  // any input stops it
    withdrawing_ = false;
    goal_.depth = hand_.depth;
    goal_.speed = usual_speed;
  }
  if (!goal_.is_down) {
    if (millimetres > 0.0) put_down();
    return;
  }
  goal_.depth = std::min(goal_.depth + millimetres, std::max(hand_.depth, 0.0) + lead);
}

// The hand's intended position then changes so that the needle stays (see MouseHand::brace).
void NeedleControl::brace(bool on) {
  const bool is_braced = on && goal_.is_down && hand_.depth > 0.0;
  if (is_braced == goal_.is_braced || held_) return;
  goal_.is_braced = is_braced;
  const double ratio = is_braced ? MouseHand::stiffness / MouseHand::braced_stiffness
                                 : MouseHand::braced_stiffness / MouseHand::stiffness;
  goal_.depth = std::min(hand_.depth + (goal_.depth - hand_.depth) * ratio, std::max(hand_.depth, 0.0) + lead);
}

void NeedleControl::push(double notches, bool fine) {
  brace(fine);
  move(notches * (fine ? fine_notch : notch));
}

void NeedleControl::drag(double millimetres) {
  move(millimetres);
}

void NeedleControl::hold_key(int direction, bool fine) {
  key_ = direction;
  fine_ = fine;
}

bool NeedleControl::tilt(double right, double cranial) {
  if (held_ || (goal_.is_down && std::max(hand_.depth, goal_.depth) > MouseHand::shallow)) return false;
  // The tip's end of the needle follows the drag: about the patient's vertical axes as seen by the operator.
  const Mat3 turn =
      (Eigen::AngleAxisd(right, Vec3::UnitZ()) * Eigen::AngleAxisd(cranial, Vec3::UnitX())).toRotationMatrix();
  Vec3 axis = (turn * goal_.axis).normalized();
  if (plan_ && plan_->length() > 0.0) {
    const Vec3 planned = plan_->direction();
    if (axis.cross(planned).norm() < straightest && axis.dot(planned) > 0.0) axis = planned;
  }
  goal_.axis = axis;
  return true;
}

void NeedleControl::withdraw() {
  if (held_ || !goal_.is_down) return;
  withdrawing_ = true;
  goal_.is_braced = false;
  goal_.depth = -lifted_height;
  goal_.speed = withdrawing;
}

void NeedleControl::hold(bool on) {
  if (on == held_) return;
  held_ = on;
  key_ = turn_key_ = 0;
  // The hand stays at its present position, not at its goal.
  if (on && goal_.is_down) goal_.depth = goal_.axis.dot(hand_.meant.translation() - goal_.at);
}

void NeedleControl::update(double dt, const HandReport& hand) {
  hand_ = hand;
  if (key_ != 0) brace(fine_);
  if (key_ != 0 && !held_) move(key_ * dt * (fine_ ? fine_key_speed : key_speed));
  if (!held_) goal_.turn += turn_key_ * dt * turn_speed;
  if (!goal_.is_down) return;
  // Withdrawn from the skin: the needle is free again.
  if (goal_.depth <= out_of_skin && hand.depth <= out_of_skin) {
    const bool has_left = !withdrawing_ || hand.depth <= -0.8 * lifted_height;
    if (has_left) {
      goal_.is_down = false;
      goal_.speed = usual_speed;
      withdrawing_ = false;
    }
  }
}

}  // namespace bodkin::app
