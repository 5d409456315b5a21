#include "station/node_field.h"

#include <algorithm>
#include <utility>

#include "fem/solid/display_columns.h"

namespace bodkin::station {

namespace {

constexpr double hand_around = 15.0;           // mm from the path, where a free hand's needle may be
constexpr std::size_t most_hand_nodes = 1000;  // that have columns
constexpr double seen_around = 90.0;           // mm from the path: what a probe above it sees
constexpr std::size_t most_bytes = std::size_t{512} << 20U;

using NearNode = std::pair<double, std::uint32_t>;  // mm, and the node

std::vector<std::uint32_t> nearest(std::vector<NearNode>& near, double around, std::size_t most) {
  std::sort(near.begin(), near.end());
  std::vector<std::uint32_t> nodes;
  for (const auto& [away, node] : near) {
    if (nodes.size() == most || (away > around && !nodes.empty())) break;
    nodes.push_back(node);
  }
  return nodes;
}

// mm between a point and the path from its entry to its target.
double distance_to(const anatomy::NeedlePath& path, const Vec3& point) {
  const Vec3 from = point - path.entry, along = path.direction();
  return (from - std::clamp(from.dot(along), 0.0, path.length()) * along).norm();
}

// `held`: how many nodes have columns.
std::vector<std::uint32_t> nodes_in_sight(const anatomy::TetrahedralMesh& mesh, const anatomy::NeedlePath& path,
                                          std::size_t held) {
  std::vector<NearNode> near;
  near.reserve(mesh.nodes.size());
  for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node)
    near.emplace_back(distance_to(path, mesh.nodes[node]), node);
  return nearest(near, seen_around, most_bytes / fem::display_bytes(1, held));
}

std::vector<fem::PointInMesh> places_of(const std::vector<std::uint32_t>& nodes) {
  std::vector<fem::PointInMesh> places;
  places.reserve(nodes.size());
  for (const std::uint32_t node : nodes) places.push_back({{node, node, node, node}, {1.0, 0.0, 0.0, 0.0}});
  return places;
}

}  // namespace

std::vector<std::uint32_t> nodes_of_shaft(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                                          const anatomy::NeedlePath& path, double around, std::size_t most) {
  std::vector<NearNode> near;
  const Vec3 along = path.direction();
  for (const std::uint32_t node : elastic.corridor()) {
    const Vec3 from = mesh.nodes[node] - path.entry;
    near.emplace_back((from - from.dot(along) * along).norm(), node);
  }
  return nearest(near, around, most);
}

NodeField::NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body,
                     const anatomy::NeedlePath& path, const Progress& progress)
    : NodeField(elastic, body, path, nodes_of_shaft(elastic, body.mesh, path, hand_around, most_hand_nodes),
                progress) {}

NodeField::NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body,
                     const anatomy::NeedlePath& path, const std::vector<std::uint32_t>& held,
                     const Progress& progress)
    : mesh_nodes_(body.mesh.nodes.size()),
      seen_(nodes_in_sight(body.mesh, path, held.size())),
      field_(fem::display_columns(elastic, places_of(seen_), held, progress)),
      moved_(3 * seen_.size(), 0.0F),
      of_mesh_(3 * mesh_nodes_, 0.0F) {}

std::span<const float> NodeField::evaluate(const fem::NodeForces& forces) noexcept {
  field_.evaluate(forces, moved_);
  for (std::size_t i = 0; i < seen_.size(); ++i)
    std::copy_n(moved_.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                of_mesh_.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{seen_[i]}));
  return of_mesh_;
}

}  // namespace bodkin::station
