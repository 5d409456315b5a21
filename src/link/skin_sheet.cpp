#include "link/skin_sheet.h"

#include <cmath>
#include <optional>

#include "station/puncture_watch.h"

namespace bodkin::link {

namespace {

constexpr int points_across = 25, middle_point = points_across / 2;
constexpr double spacing = 3.0;              // mm
constexpr double before = 40.0;              // mm of the plan's line searched for skin, and as many behind
constexpr double step = 0.25;                // mm
constexpr double farthest_from_sheet = 5.0;  // mm, of a point that moves with the skin

// Of the point in column i and row j.
std::size_t index_of(int i, int j) {
  return static_cast<std::size_t>(j) * points_across + static_cast<std::size_t>(i);
}

// The first non-air place along the line.
std::optional<Vec3> skin_on(const anatomy::TissueVolume& tissues, const Vec3& from, const Vec3& along) {
  for (double way = -before; way <= before; way += step) {
    const Vec3 point = from + way * along;
    if (anatomy::nearest(tissues, point, anatomy::tissue::air) != anatomy::tissue::air) return point;
  }
  return std::nullopt;
}

}  // namespace

SkinSheet::SkinSheet(const anatomy::Case& patient) {
  const std::optional<anatomy::NeedlePath>& path = patient.description.procedure.path;
  if (!path || !(path->length() > 0.0)) return;
  const Vec3 along = path->direction();
  middle_ = path->entry;
  right_ = along.unitOrthogonal();
  up_ = along.cross(right_);
  index_.assign(static_cast<std::size_t>(points_across) * points_across, -1);
  const auto at = [&](int i, int j) -> int& { return index_[index_of(i, j)]; };
  for (int j = 0; j < points_across; ++j) {
    for (int i = 0; i < points_across; ++i) {
      const double x = spacing * (i - middle_point), y = spacing * (j - middle_point);
      const std::optional<Vec3> skin = skin_on(patient.tissues, middle_ + x * right_ + y * up_, along);
      if (!skin) continue;
      at(i, j) = static_cast<int>(rest_.size());
      rest_.push_back(*skin);
    }
  }
  for (int j = 0; j + 1 < points_across; ++j) {
    for (int i = 0; i + 1 < points_across; ++i) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (a >= 0 && b >= 0 && c >= 0) triangles_.push_back({a, b, c});
      if (a >= 0 && c >= 0 && d >= 0) triangles_.push_back({a, c, d});
    }
  }
}

std::vector<Vec3> SkinSheet::moved(const Pose& needle, double dimple, std::span<const float> displacements) const {
  std::vector<Vec3> points = rest_;
  if (displacements.size() == 3 * points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] += Eigen::Map<const Eigen::Vector3f>(&displacements[3 * i]).cast<double>();
    return points;
  }
  if (dimple == 0.0) return points;
  const Vec3 along = needle_axis(needle);
  for (Vec3& point : points) {
    const Vec3 from = point - needle.translation();
    const double distance = (from - from.dot(along) * along).norm();
    point += dimple * station::dimple_share(distance) * along;
  }
  return points;
}

std::vector<float> SkinSheet::displacements_at(std::span<const Vec3> points, std::span<const Vec3> moved) const {
  std::vector<float> found(3 * points.size(), 0.0F);
  if (moved.size() != rest_.size()) return found;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec3 from = points[p] - middle_;
    const double x = from.dot(right_) / spacing + middle_point, y = from.dot(up_) / spacing + middle_point;
    const double left = std::floor(x), low = std::floor(y);
    if (!(left >= 0.0 && low >= 0.0 && left + 1.0 < points_across && low + 1.0 < points_across)) continue;
    Vec3 sum = Vec3::Zero(), at_rest = Vec3::Zero();
    double weights = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
      const int right = corner % 2, up = corner / 2;
      const int at = index_[index_of(static_cast<int>(left) + right, static_cast<int>(low) + up)];
      if (at < 0) continue;
      const auto i = static_cast<std::size_t>(at);
      const double weight = (right == 1 ? x - left : 1.0 - (x - left)) * (up == 1 ? y - low : 1.0 - (y - low));
      sum += weight * (moved[i] - rest_[i]);
      at_rest += weight * rest_[i];
      weights += weight;
    }
    if (weights == 0.0 || (points[p] - at_rest / weights).norm() > farthest_from_sheet) continue;
    sum /= weights;
    for (std::size_t axis = 0; axis < 3; ++axis)
      found[3 * p + axis] = static_cast<float>(sum[static_cast<Eigen::Index>(axis)]);
  }
  return found;
}

}  // namespace bodkin::link
