#include "imaging/ultrasound_screen/probe_on_skin.h"

#include <algorithm>
#include <optional>

#include "core/shortest_turn.h"
#include "imaging/ultrasound_screen/skin.h"

namespace bodkin::imaging {

namespace {

constexpr double skin_reach = 25.0;                        // mm up or down to the skin after a step
constexpr double most_pressed = 40.0, most_lifted = 60.0;  // mm

}  // namespace

ProbeOnSkin::ProbeOnSkin(const Pose& pose) : ProbeOnSkin(pose, -pose.linear().col(1)) {}

ProbeOnSkin::ProbeOnSkin(const Pose& pose, const Vec3& outward) : pose_(pose), outward_(outward) {}

Pose ProbeOnSkin::pose() const {
  Pose pressed = pose_;
  pressed.translation() += press_ * pose_.linear().col(1);
  return pressed;
}

void ProbeOnSkin::press(double millimetres) {
  press_ = std::clamp(millimetres, -most_lifted, most_pressed);
}

bool ProbeOnSkin::slide(const anatomy::TissueVolume& tissues, double along, double across) {
  Vec3 shift = along * pose_.linear().col(0) + across * pose_.linear().col(2);
  const double length = shift.norm();
  shift -= shift.dot(outward_) * outward_;
  if (!(shift.norm() > 0.0)) return false;
  shift *= length / shift.norm();
  const std::optional<SkinPoint> skin = skin_near(tissues, pose_.translation() + shift, outward_, skin_reach);
  if (!skin) {
    // A probe far from the skin moves freely, so that it can return.
    if (skin_near(tissues, pose_.translation(), outward_, skin_reach) || !shift.allFinite()) return false;
    pose_.translation() += shift;
    return true;
  }
  const Eigen::Quaterniond turn = shortest_turn(outward_, skin->outward);
  // A step that would turn the probe over has reached another side of a thin part.
  if (outward_.dot(skin->outward) < 0.0) return false;
  pose_.linear() = Eigen::Quaterniond(turn * Eigen::Quaterniond(pose_.linear())).normalized().toRotationMatrix();
  pose_.translation() = skin->place;
  outward_ = skin->outward;
  return true;
}

void ProbeOnSkin::rotate(double angle) {
  pose_.rotate(Eigen::AngleAxisd(angle, Vec3::UnitY()));
}

void ProbeOnSkin::tilt(double angle) {
  pose_.rotate(Eigen::AngleAxisd(angle, Vec3::UnitX()));
}

void ProbeOnSkin::rock(double angle) {
  pose_.rotate(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
}

}  // namespace bodkin::imaging
