#include "station/axial_needle.h"

#include <algorithm>
#include <cmath>

#include "core/rotation.h"

namespace bodkin::station {

namespace {
constexpr double return_speed = 50.0;  // mm/s
constexpr double return_turn = 0.5;    // rad/s
}  // namespace

Pose AxialNeedle::step(const Pose& hand, bool in_tissue, double dt) noexcept {
  if (!seen_) needle_ = last_hand_ = hand;
  seen_ = true;
  const Vec3 moved = hand.translation() - last_hand_.translation();
  if (in_tissue) {
    const Vec3 axis = needle_.linear().col(2);
    needle_.translation() += axis.dot(moved) * axis;
    const Mat3 turn = hand.linear() * last_hand_.linear().transpose();
    const Vec3 about = 0.5 * Vec3(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
    needle_.linear() = rotation_about(axis, axis.dot(about)) * needle_.linear();
  } else {
    // Together with the hand, and towards it.
    needle_.translation() += moved;
    needle_.linear() = hand.linear() * last_hand_.linear().transpose() * needle_.linear();
    const Vec3 away = hand.translation() - needle_.translation();
    const double distance = away.norm(), step = return_speed * dt;
    needle_.translation() =
        distance <= step ? Vec3(hand.translation()) : Vec3(needle_.translation() + step / distance * away);
    const AxisAngle turn = axis_angle_of(hand.linear() * needle_.linear().transpose());
    needle_.linear() = turn.angle <= return_turn * dt
                           ? Mat3(hand.linear())
                           : Mat3(rotation_about(turn.axis, return_turn * dt) * needle_.linear());
  }
  last_hand_ = hand;
  return needle_;
}

}  // namespace bodkin::station
