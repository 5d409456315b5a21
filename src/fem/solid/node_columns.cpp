#include "fem/solid/node_columns.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace bodkin::fem {

namespace {

constexpr std::size_t loads_at_once = 8;  // that share one pass over the factor

// With the positions of their nodes in the sorted `nodes`.
std::vector<PointInMesh> within(std::vector<PointInMesh> points, const std::vector<std::uint32_t>& nodes) {
  for (PointInMesh& point : points)
    for (std::uint32_t& node : point.nodes)
      node = static_cast<std::uint32_t>(std::ranges::lower_bound(nodes, node) - nodes.begin());
  return points;
}

}  // namespace

NodeColumns::NodeColumns(std::shared_ptr<const ContactBody> body, std::vector<PointInMesh> points,
                         const LeftNeedleForces& left)
    : body_(std::move(body)), left_(left) {
  for (const std::vector<PointInMesh>* const all : {&std::as_const(points), &left_.places()})
    for (const PointInMesh& point : *all) nodes_.insert(nodes_.end(), point.nodes.begin(), point.nodes.end());
  std::ranges::sort(nodes_);
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  points_ = within(std::move(points), nodes_);
  left_places_ = within(left_.places(), nodes_);
  const std::vector<PointInMesh>& places = left_.places();
  by_left_.resize(3 * static_cast<Eigen::Index>(points_.size()), 3 * static_cast<Eigen::Index>(places.size()));
  for (std::size_t from = 0; from < places.size(); from += loads_at_once) {
    std::vector<CarriedPoint> loads;
    for (std::size_t i = from; i < std::min(places.size(), from + loads_at_once); ++i)
      loads.push_back(body_->carried(places[i]));
    by_left_.middleCols(3 * static_cast<Eigen::Index>(from), 3 * static_cast<Eigen::Index>(loads.size())) =
        at_places(points_, body_->displacements(loads, nodes_)).cast<float>();
  }
}

Eigen::MatrixXf NodeColumns::of(std::span<const std::uint32_t> nodes) const {
  Eigen::MatrixXf found(3 * static_cast<Eigen::Index>(points_.size()), 3 * static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t from = 0; from < nodes.size(); from += loads_at_once) {
    std::vector<CarriedPoint> loads;
    for (std::size_t i = from; i < std::min(nodes.size(), from + loads_at_once); ++i) {
      const std::uint32_t node = nodes[i];
      loads.push_back(body_->carried({{node, node, node, node}, {1.0, 0.0, 0.0, 0.0}}));
    }
    const Eigen::MatrixXd moved = body_->displacements(loads, nodes_);
    Eigen::MatrixXf columns = at_places(points_, moved).cast<float>();
    if (!left_.empty())
      columns.noalias() += by_left_ * left_.against_places(at_places(left_places_, moved)).cast<float>();
    found.middleCols(3 * static_cast<Eigen::Index>(from), columns.cols()) = columns;
  }
  return found;
}

}  // namespace bodkin::fem
