#include "station/left_needle_motion.h"

#include <algorithm>
#include <cmath>

namespace bodkin::station {

namespace {

constexpr double followed_spacing = 5.0;  // mm between the points of a needle, at most
constexpr std::size_t fewest_points = 3;  // of a needle

}  // namespace

// Part s mm below the entry belongs at x(s). With c + s a for the needle, |a| = 1, the sum of |x - c - s a|^2 is
// least for the mean of x - s a as c and for a along the sum of (s - mean s) x.
Pose rigid_needle(std::span<const Vec3> places, double length) {
  const double step = length / static_cast<double>(places.size() - 1);
  Vec3 middle = Vec3::Zero(), along = Vec3::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) {
    middle += places[i] / static_cast<double>(places.size());
    along += (static_cast<double>(i) * step - 0.5 * length) * places[i];
  }
  // Tissue contracted to one point determines no direction: that between the needle's ends, or any.
  if (!(along.norm() > 0.0)) along = places.back() - places.front();
  if (!(along.norm() > 0.0)) along = Vec3::UnitZ();
  const Vec3 axis = along.normalized();
  return needle_pose(middle + 0.5 * length * axis, axis);
}

LeftNeedleMotion::LeftNeedleMotion(const std::vector<anatomy::NeedlePath>& left,
                                   const std::optional<anatomy::BreathField>& breath)
    : breath_(breath) {
  for (const anatomy::NeedlePath& path : left) {
    const double length = path.length();
    const std::size_t count =
        std::max(fewest_points, static_cast<std::size_t>(std::ceil(length / followed_spacing)) + 1);
    left_.push_back({points_.size(), count, length});
    for (std::size_t i = 0; i < count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count - 1);
      points_.emplace_back(path.entry + share * (path.target - path.entry));
    }
  }
  places_ = points_;
  poses_.resize(left_.size());
}

Vec3 LeftNeedleMotion::breathed(std::size_t point, double drawn_in) const noexcept {
  return breath_ ? breath_->moved(points_[point], drawn_in) : Vec3(Vec3::Zero());
}

const std::vector<Pose>& LeftNeedleMotion::poses(std::span<const float> displacements, double drawn_in) {
  const bool is_given = displacements.size() == 3 * points_.size();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    places_[i] = points_[i] + breathed(i, drawn_in);
    if (is_given) places_[i] += Eigen::Map<const Eigen::Vector3f>(displacements.data() + 3 * i).cast<double>();
  }
  for (std::size_t i = 0; i < left_.size(); ++i) {
    const Left& one = left_[i];
    poses_[i] = rigid_needle(std::span<const Vec3>(places_).subspan(one.first, one.count), one.length);
  }
  return poses_;
}

}  // namespace bodkin::station
