#include "station/followed_points.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "station/node_field.h"
#include "station/slice_field.h"

#include "fem/solid/display_columns.h"

namespace bodkin::station {

namespace {

constexpr std::size_t spare_nodes = 480;  // for a needle away from the path, and what a probe holds
constexpr double probe_around = 80.0;     // mm about the entry, where a needle feels a probe

// Appends these nodes of the mesh as points.
std::vector<fem::PointInMesh> with_nodes(std::vector<fem::PointInMesh> points,
                                         const std::vector<std::uint32_t>& nodes) {
  for (const std::uint32_t node : nodes) points.push_back(place_of_node(node));
  return points;
}

}  // namespace

FollowedPoints::FollowedPoints(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                               const anatomy::NeedlePath& path, const std::vector<Vec3>& points,
                               const Progress& progress, const fem::LeftNeedleForces& left,
                               std::shared_ptr<const fem::ContactBody> whole, std::span<const std::uint32_t> surface)
    : mesh_(mesh),
      left_(left),
      whole_(std::move(whole)),
      surface_(surface.begin(), surface.end()),
      points_(fem::find_points(mesh, points)) {
  const std::vector<std::uint32_t> may_be_held = nodes_held_near(path.entry);
  std::vector<fem::PointInMesh> all = with_nodes(points_, may_be_held);
  fem::DisplayField field = fem::display_columns(elastic, all, nodes_of_shaft(elastic, mesh, path), progress, left_,
                                                 whole_ == nullptr ? 0 : spare_nodes);
  display_ = std::make_shared<simulation::DisplayThread>(
      growing_field(std::move(field), whole_, std::move(all), left_, may_be_held));
}

std::vector<std::uint32_t> FollowedPoints::nodes_held_near(const Vec3& entry) const {
  std::vector<std::uint32_t> near;
  for (const std::uint32_t node : surface_)
    if (whole_ != nullptr && (mesh_.nodes[node] - entry).norm() <= probe_around) near.push_back(node);
  return near;
}

void FollowedPoints::follow(const std::vector<Vec3>& points, const Vec3& entry) {
  if (whole_ == nullptr || points.empty()) return;
  std::vector<fem::PointInMesh> found = fem::find_points(mesh_, points);
  const std::vector<std::uint32_t> may_be_held = nodes_held_near(entry);
  std::vector<fem::PointInMesh> all = with_nodes(found, may_be_held);
  fem::DisplayField field(all.size(), {}, mesh_.nodes.size(), spare_nodes);
  display_->show(growing_field(std::move(field), whole_, std::move(all), left_, may_be_held));
  points_ = std::move(found);
  by_itself_.clear();
}

void FollowedPoints::update(std::span<const float> nodes, std::span<const std::uint32_t> held) {
  move_points(points_, nodes, by_itself_);
  display_->hold(held);
}

std::span<const float> FollowedPoints::displacements() {
  const std::span<const float> by_needle =
      std::span<const float>(display_->snapshot().displacements).first(3 * points_.size());
  if (by_itself_.empty()) return by_needle;
  sum_ = by_itself_;
  for (std::size_t i = 0; i < std::min(sum_.size(), by_needle.size()); ++i) sum_[i] += by_needle[i];
  return sum_;
}

}  // namespace bodkin::station
