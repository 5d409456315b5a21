#include "training/interspace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace bodkin::training {

namespace {

constexpr std::string_view skin_suffix = "_skin";

// Unit, towards the head, along the landmarks beside the one at `index`.
Vec3 line_at(const std::vector<anatomy::Landmark>& levels, std::size_t index) {
  const Vec3& above = levels[index + 1 < levels.size() ? index + 1 : index].position;
  const Vec3& below = levels[index > 0 ? index - 1 : 0].position;
  const Vec3 way = above - below;
  return way.norm() > 1.0 ? Vec3(way.normalized()) : Vec3(Vec3::UnitZ());
}

}  // namespace

std::optional<SkinPlace> skin_place(const Vec3& place, const anatomy::CaseDescription& description) {
  std::vector<anatomy::Landmark> levels;
  for (const anatomy::Landmark& each : description.landmarks) {
    if (each.name.ends_with(skin_suffix))
      levels.push_back({each.name.substr(0, each.name.size() - skin_suffix.size()), each.position});
  }
  if (levels.empty()) return std::nullopt;
  std::stable_sort(levels.begin(), levels.end(), [](const anatomy::Landmark& a, const anatomy::Landmark& b) {
    return a.position.z() < b.position.z();
  });
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double distance = (levels[i].position - place).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  const Vec3 offset = place - levels[nearest].position, along = line_at(levels, nearest);
  SkinPlace found{.level = levels[nearest].name, .along = offset.dot(along), .midline = 0.0};
  // Only across the back: the offset in front of or behind the line is the curve of the skin.
  const Vec3 side = Vec3(along.z(), 0.0, -along.x());
  found.midline = side.norm() > 1e-6 ? std::abs(offset.dot(side.normalized())) : 0.0;
  return found;
}

std::string spoken_level(std::string level) {
  std::replace(level.begin(), level.end(), '_', '/');
  return level;
}

}  // namespace bodkin::training
