#include "station/followed_points.h"

#include <cstddef>

#include "station/node_field.h"

#include "fem/solid/display_columns.h"

namespace bodkin::station {

FollowedPoints::FollowedPoints(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                               const anatomy::NeedlePath& path, const std::vector<Vec3>& points,
                               const Progress& progress)
    : display_(std::make_shared<simulation::DisplayThread>(fem::display_columns(
          elastic, fem::find_points(mesh, points), nodes_of_shaft(elastic, mesh, path), progress))) {}

FollowedPoints::FollowedPoints(const anatomy::TetrahedralMesh& mesh, const std::vector<Vec3>& points)
    : points_(fem::find_points(mesh, points)), moved_(3 * points.size(), 0.0F) {}

void FollowedPoints::update(std::span<const float> nodes) noexcept {
  for (std::size_t point = 0; point < points_.size(); ++point) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t corner = 0; corner < 4; ++corner) {
      sum += static_cast<float>(points_[point].weights[corner]) *
             Eigen::Map<const Eigen::Vector3f>(nodes.data() + 3 * std::size_t{points_[point].nodes[corner]});
    }
    Eigen::Map<Eigen::Vector3f>(moved_.data() + 3 * point) = sum;
  }
}

std::span<const float> FollowedPoints::displacements() noexcept {
  return display_ == nullptr ? std::span<const float>(moved_) : display_->snapshot().displacements;
}

}  // namespace bodkin::station
