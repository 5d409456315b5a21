#include "haptics/workspace_map.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/rotation.h"
#include "core/settings_check.h"

namespace bodkin::haptics {

namespace {

constexpr double rotation_slack = 1e-6;

bool is_rotation(const Mat3& turn, double slack) noexcept {
  return (turn.transpose() * turn - Mat3::Identity()).cwiseAbs().maxCoeff() <= slack && turn.determinant() > 0.0;
}

constexpr auto of_workspace = "workspace";

// Throws InputError unless the matrix is a rotation, NaN included.
void check_rotation(const Mat3& turn, const std::string& what) {
  if (is_rotation(turn, rotation_slack)) return;
  refuse_setting(of_workspace,
                 "the determinant of the " + what + " is " + number_words(turn.determinant()) +
                     ", expected three perpendicular unit axes, right-handed; correct the device's profile");
}

}  // namespace

void check(const WorkspaceSettings& settings) {
  check_rotation(settings.rotation, "rotation");
  check_rotation(settings.tool_rotation, "tool's rotation");
  for (int axis = 0; axis < 3; ++axis)
    check_range(of_workspace, "coordinate of the centre", settings.centre[axis], any_number, "mm");
  check_range(of_workspace, "distance of the middle", settings.hand_middle.norm(), {0.0, 3500.0}, "mm");
  check_range(of_workspace, "offset of the tip", settings.tip_offset.norm(), {0.0, 1000.0}, "mm");
  check_range(of_workspace, "scale", settings.scale, {0.1, 10.0}, "");
  check_range(of_workspace, "force scale", settings.force_scale, {0.01, 1.0}, "");
  check_range(of_workspace, "speed of the body", settings.body_speed, above(0.0, 1000.0), "mm/s");
  check_range(of_workspace, "turning speed of the body", settings.body_turn, above(0.0, 10.0), "rad/s");
}

WorkspaceMap::WorkspaceMap(const WorkspaceSettings& settings)
    : settings_((check(settings), settings)),
      wanted_centre_(settings.centre),
      wanted_rotation_(settings.rotation),
      grip_(settings.tool_rotation) {}

Vec3 WorkspaceMap::tip_of(const Pose& hand) const noexcept {
  return settings_.scale * (hand.translation() - settings_.hand_middle + hand.linear() * settings_.tip_offset);
}

void WorkspaceMap::move_body(const Vec3& middle, const Mat3& rotation) noexcept {
  if (!middle.allFinite() || !is_rotation(rotation, rotation_slack)) return;
  wanted_centre_ = middle;
  wanted_rotation_ = rotation;
  body_moving_ = true;
}

void WorkspaceMap::glide(double dt) noexcept {
  if (!body_moving_) return;
  const Vec3 offset = wanted_centre_ - settings_.centre;
  const AxisAngle turn = axis_angle_of(wanted_rotation_ * settings_.rotation.transpose());
  const double share = std::min({1.0, settings_.body_speed * dt / std::max(offset.norm(), 1e-12),
                                 settings_.body_turn * dt / std::max(turn.angle, 1e-12)});
  if (share >= 1.0) {
    settings_.centre = wanted_centre_;
    settings_.rotation = wanted_rotation_;
    body_moving_ = false;
    return;
  }
  settings_.centre += share * offset;
  // By a quaternion, so that many small turns do not degrade the axes.
  const Eigen::Quaterniond next(Mat3(rotation_about(turn.axis, share * turn.angle) * settings_.rotation));
  settings_.rotation = next.normalized().toRotationMatrix();
}

// The needle stays where it is in the patient; the hand's hold changes accordingly.
void WorkspaceMap::grasp(const Pose& hand) noexcept {
  shift_ = settings_.rotation.transpose() * (needle_.translation() - settings_.centre) - tip_of(hand);
  grip_ = hand.linear().transpose() * settings_.rotation.transpose() * needle_.linear();
}

const Pose& WorkspaceMap::step(const Pose& hand, double dt) noexcept {
  glide(dt);
  lever_ = hand.linear() * settings_.tip_offset;
  // A needle never held by a hand has no place to stay.
  if (is_held() && begun_) {
    was_held_ = true;
    return needle_;
  }
  if (was_held_) grasp(hand);
  was_held_ = false;
  begun_ = true;
  needle_.translation() = settings_.centre + settings_.rotation * (tip_of(hand) + shift_);
  needle_.linear() = settings_.rotation * hand.linear() * grip_;
  return needle_;
}

void WorkspaceMap::carry(const Vec3& by, const Mat3& turn) noexcept {
  if (!is_held() || !begun_ || !by.allFinite() || !is_rotation(turn, rotation_slack)) return;
  needle_.translation() += by;
  // By a quaternion, so that many small turns do not degrade the axes.
  if (turn != Mat3::Identity())
    needle_.linear() = Eigen::Quaterniond(Mat3(turn * needle_.linear())).normalized().toRotationMatrix();
}

Wrench WorkspaceMap::felt(const Wrench& on_needle) const noexcept {
  if (is_held()) return {};
  Wrench hand;
  hand.force = settings_.force_scale * (settings_.rotation.transpose() * on_needle.force);
  hand.torque =
      settings_.force_scale * (settings_.rotation.transpose() * on_needle.torque) + lever_.cross(hand.force);
  return hand;
}

}  // namespace bodkin::haptics
