#include "station/followed_points.h"

#include <algorithm>
#include <cstddef>

#include "station/node_field.h"

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
  by_itself_.resize(3 * points_.size());
  for (std::size_t point = 0; point < points_.size(); ++point) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t corner = 0; corner < 4; ++corner) {
      sum += static_cast<float>(points_[point].weights[corner]) *
             Eigen::Map<const Eigen::Vector3f>(nodes.data() + 3 * std::size_t{points_[point].nodes[corner]});
    }
    Eigen::Map<Eigen::Vector3f>(by_itself_.data() + 3 * point) = sum;
  }
}

std::span<const float> FollowedPoints::displacements() {
  const std::span<const float> by_needle = display_->snapshot().displacements;
  if (by_itself_.empty()) return by_needle;
  sum_ = by_itself_;
  for (std::size_t i = 0; i < std::min(sum_.size(), by_needle.size()); ++i) sum_[i] += by_needle[i];
  return sum_;
}

}  // namespace bodkin::station
