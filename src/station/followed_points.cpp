#include "station/followed_points.h"

#include <algorithm>
#include <cstddef>

#include "station/node_field.h"
#include "station/slice_field.h"

#include "fem/solid/display_columns.h"

namespace bodkin::station {

FollowedPoints::FollowedPoints(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                               const anatomy::NeedlePath& path, const std::vector<Vec3>& points,
                               const Progress& progress)
    : points_(fem::find_points(mesh, points)) {
  display_ = std::make_shared<simulation::DisplayThread>(
      fem::display_columns(elastic, points_, nodes_of_shaft(elastic, mesh, path), progress));
}

void FollowedPoints::update(std::span<const float> nodes) {
  move_points(points_, nodes, by_itself_);
}

std::span<const float> FollowedPoints::displacements() {
  const std::span<const float> by_needle = display_->snapshot().displacements;
  if (by_itself_.empty()) return by_needle;
  sum_ = by_itself_;
  for (std::size_t i = 0; i < std::min(sum_.size(), by_needle.size()); ++i) sum_[i] += by_needle[i];
  return sum_;
}

}  // namespace bodkin::station
