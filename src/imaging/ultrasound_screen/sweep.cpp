#include "imaging/ultrasound_screen/sweep.h"

#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "imaging/ultrasound_screen/skin.h"

namespace bodkin::imaging {

namespace {

constexpr int most_frames = 100000;
constexpr double sweep_reach = 50.0;  // mm up or down to the skin from the straight line

double between(const SweepAngle& angle, double share) {
  return angle.from + share * (angle.to - angle.from);
}

// mm of the face beyond the skin along `depth`; 0 where there is no skin.
double depth_in_skin(const anatomy::TissueVolume& tissues, const Vec3& face, const Vec3& depth) {
  const std::optional<SkinPoint> skin = skin_near(tissues, face, -depth, sweep_reach);
  return skin ? depth.dot(face - skin->place) : 0.0;
}

}  // namespace

std::vector<SweepPose> sweep_of(const Pose& first, const SweepMotion& motion, const anatomy::TissueVolume& tissues) {
  if (motion.frames < 1 || motion.frames > most_frames || !(motion.rate > 0.0)) {
    throw InputError(fmt::format("a sweep of {} frames at {} a second is none, expected 1 to {} frames",
                                 motion.frames, motion.rate, most_frames));
  }
  const Vec3 start = first.translation(), depth = first.linear().col(1);
  const Vec3 end = motion.to.value_or(start);
  const double pressed = motion.on_skin ? depth_in_skin(tissues, start, depth) : 0.0;
  std::vector<SweepPose> poses;
  poses.reserve(static_cast<std::size_t>(motion.frames));
  for (int frame = 0; frame < motion.frames; ++frame) {
    const double share = motion.frames > 1 ? static_cast<double>(frame) / (motion.frames - 1) : 0.0;
    SweepPose next{frame / motion.rate, first};
    Vec3 face = start + share * (end - start);
    if (motion.on_skin) {
      if (const auto skin = skin_near(tissues, face, -depth, sweep_reach)) face = skin->place + pressed * depth;
    }
    next.pose.translation() = face;
    next.pose.rotate(Eigen::AngleAxisd(between(motion.rotate, share), Vec3::UnitY()) *
                     Eigen::AngleAxisd(between(motion.tilt, share), Vec3::UnitX()) *
                     Eigen::AngleAxisd(between(motion.rock, share), Vec3::UnitZ()));
    poses.push_back(next);
  }
  return poses;
}

}  // namespace bodkin::imaging
