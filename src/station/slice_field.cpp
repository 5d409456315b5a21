#include "station/slice_field.h"

#include <utility>

#include "imaging/warped_slice.h"

namespace bodkin::station {

namespace {

bool same_grid(const imaging::SlicePlane& a, const imaging::SlicePlane& b) {
  return a.corner == b.corner && a.right == b.right && a.down == b.down && a.pixel == b.pixel && a.width == b.width &&
         a.height == b.height;
}

}  // namespace

imaging::SlicePlane plane_of_frame(const imaging::UltrasoundFrame& frame, const Pose& probe) {
  imaging::SlicePlane plane;
  plane.corner = probe * frame.corner;
  plane.right = probe.linear().col(0);
  plane.down = probe.linear().col(1);
  plane.pixel = frame.pixel;
  plane.width = frame.width;
  plane.height = frame.height;
  return plane;
}

void move_points(std::span<const fem::PointInMesh> points, std::span<const float> nodes, std::vector<float>& moved) {
  moved.resize(3 * points.size());
  for (std::size_t point = 0; point < points.size(); ++point) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::size_t corner = 0; corner < 4; ++corner) {
      sum += static_cast<float>(points[point].weights[corner]) *
             Eigen::Map<const Eigen::Vector3f>(nodes.data() + 3 * std::size_t{points[point].nodes[corner]});
    }
    Eigen::Map<Eigen::Vector3f>(moved.data() + 3 * point) = sum;
  }
}

SliceField::SliceField(std::shared_ptr<const fem::BodyDescription> body)
    : body_(std::move(body)), finder_(body_->mesh) {}

std::span<const float> SliceField::displacements(const imaging::SlicePlane& grid, std::span<const float> nodes) {
  if (places_.empty() || !same_grid(grid, grid_)) {
    grid_ = grid;
    places_.clear();
    for (const Vec3& point : imaging::points_of(grid)) places_.push_back(finder_.find(point));
  }
  move_points(places_, nodes, moved_);
  return moved_;
}

}  // namespace bodkin::station
