#include "link/skin_sheet.h"

#include <optional>

#include "station/puncture_watch.h"

namespace bodkin::link {

namespace {

constexpr int points_across = 25;
constexpr double spacing = 3.0;  // mm
constexpr double before = 40.0;  // mm of the plan's line that are searched for skin, and as many behind
constexpr double step = 0.25;    // mm

// The first place along the line that is not air.
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
  const Vec3 along = path->direction(), right = along.unitOrthogonal(), up = along.cross(right);
  std::vector<int> index(static_cast<std::size_t>(points_across) * points_across, -1);
  const auto at = [&](int i, int j) -> int& { return index[static_cast<std::size_t>(j * points_across + i)]; };
  for (int j = 0; j < points_across; ++j) {
    for (int i = 0; i < points_across; ++i) {
      const double x = spacing * (i - points_across / 2), y = spacing * (j - points_across / 2);
      const std::optional<Vec3> skin = skin_on(patient.tissues, path->entry + x * right + y * up, along);
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

}  // namespace bodkin::link
