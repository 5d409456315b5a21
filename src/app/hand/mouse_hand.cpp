#include "app/hand/mouse_hand.h"

#include <algorithm>
#include <cmath>

namespace bodkin::app {

namespace {

constexpr double same_place = 1e-3, same_direction = 1e-4;  // mm, rad
constexpr double near_skin = 3.0;                           // mm above it, where the hand slows down

// The tremor of a hand at rest, far too small to see; the guard would treat a device with constant readings under
// force as broken.
constexpr double unease = 0.002;  // mm

constexpr double usual_damping = 0.02;  // N s/mm, critical
constexpr double braced_damping = 0.6;  // a force of 4 N that is gone moves it at 7 mm/s

haptics::HandParameters hand_parameters() {
  haptics::HandParameters hand;
  hand.mass = 0.1;
  hand.stiffness = MouseHand::stiffness;
  hand.damping = usual_damping;
  hand.tremor = unease;
  return hand;
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

Pose turned_needle(const Vec3& tip, const Vec3& axis, double turn) noexcept {
  Pose pose = needle_pose(tip, axis);
  pose.linear() = pose.linear() * Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
  return pose;
}

MouseHand::MouseHand(double dt) : dt_(dt), hand_(hand_parameters(), dt, 1) {}

void MouseHand::start(const HandGoal& goal) noexcept {
  at_ = goal.at;
  axis_ = goal.axis;
  turn_ = goal.turn;
  place_ = -waiting;
  speed_ = 0.0;
  braced_ = false;
  hand_.set_grip(stiffness, usual_damping, at_ + place_ * axis_);
  const Pose pose = turned_needle(at_ + place_ * axis_, axis_, turn_);
  hand_.start(pose);
  report_ = {pose, pose, place_, true};
}

// The needle stays in place: the hand's intended position moves nearer to it, or farther ahead.
void MouseHand::brace(bool on) noexcept {
  if (on == braced_) return;
  braced_ = on;
  const double ratio = on ? stiffness / braced_stiffness : braced_stiffness / stiffness;
  place_ = report_.depth + (place_ - report_.depth) * ratio;
  hand_.set_grip(on ? braced_stiffness : stiffness, on ? braced_damping : usual_damping, at_ + place_ * axis_);
}

void MouseHand::turn_towards(const Vec3& axis) noexcept {
  const double angle = angle_between(axis_, axis);
  if (angle < same_direction) {
    axis_ = axis;
    return;
  }
  const double step = std::min(angle, turning_speed * dt_);
  const Vec3 about = axis_.cross(axis);
  if (about.norm() < 1e-9) return;  // opposite: no direction is shorter
  axis_ = (Eigen::AngleAxisd(step, about.normalized()) * axis_).normalized();
}

void MouseHand::follow_line(const HandGoal& goal) noexcept {
  const Vec3 way = goal.at - at_;
  const bool is_elsewhere = way.norm() > same_place;
  const bool is_up = place_ < -0.5 * waiting && report_.depth < 0.0;
  if (is_elsewhere && is_up) {
    at_ += std::min(1.0, aiming_speed * dt_ / way.norm()) * way;
    turn_towards(goal.axis);
  } else if (!is_elsewhere && report_.depth <= shallow) {
    at_ = goal.at;
    turn_towards(goal.axis);
  }
}

const Pose& MouseHand::step(const HandGoal& goal, const Vec3& force) noexcept {
  follow_line(goal);
  brace(goal.is_braced);
  report_.is_on_line = (goal.at - at_).norm() <= same_place && angle_between(axis_, goal.axis) <= same_direction;
  const bool may_go_down =
      goal.is_down && (report_.is_on_line || place_ > -0.5 * waiting) && (goal.at - at_).norm() <= same_place;
  const double goal_depth = may_go_down ? goal.depth : -waiting;
  const bool in_air = place_ < -near_skin && report_.depth < -near_skin;
  const double most = in_air ? air_speed : goal.speed;
  const double wanted = std::clamp((goal_depth - place_) / (2.0 * smoothing), -most, most);
  speed_ += (wanted - speed_) * std::min(1.0, 2.0 * dt_ / smoothing);
  place_ += speed_ * dt_;
  turn_ += std::clamp(goal.turn - turn_, -twirling_speed * dt_, twirling_speed * dt_);
  const Pose meant = turned_needle(at_ + place_ * axis_, axis_, turn_);
  const Vec3 along = axis_ * axis_.dot(force);
  report_.needle = hand_.step(meant, {along, Vec3::Zero()});
  report_.meant = meant;
  report_.depth = axis_.dot(report_.needle.translation() - at_);
  return report_.needle;
}

}  // namespace bodkin::app
