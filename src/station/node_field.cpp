#include "station/node_field.h"

#include <algorithm>
#include <utility>

#include "fem/solid/display_columns.h"
#include "fem/solid/node_columns.h"

namespace bodkin::station {

namespace {

constexpr double before_entry = 5.0, behind_target = 15.0;  // mm, of the line about which a display has forces
constexpr double picture_around = 25.0;                     // mm from that line
constexpr std::size_t most_picture_nodes = 1000;
constexpr double hand_around = 15.0;           // mm from the path, where a free hand's needle may be
constexpr std::size_t most_hand_nodes = 1000;  // that have columns
constexpr std::size_t spare_hand_nodes = 400;  // of these, for a needle farther away and nodes held by a probe
constexpr double seen_around = 90.0;           // mm from the path: the view of a probe above it
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

// `with_columns`: how many nodes have columns.
std::vector<std::uint32_t> nodes_in_sight(const anatomy::TetrahedralMesh& mesh, const anatomy::NeedlePath& path,
                                          std::size_t with_columns) {
  std::vector<NearNode> near;
  near.reserve(mesh.nodes.size());
  for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node)
    near.emplace_back(distance_to(path, mesh.nodes[node]), node);
  return nearest(near, seen_around, most_bytes / fem::display_bytes(1, with_columns));
}

std::vector<fem::PointInMesh> places_of(const std::vector<std::uint32_t>& nodes) {
  std::vector<fem::PointInMesh> places;
  places.reserve(nodes.size());
  for (const std::uint32_t node : nodes) places.push_back(place_of_node(node));
  return places;
}

}  // namespace

std::vector<std::uint32_t> nodes_of_picture(const fem::BodyDescription& body, const anatomy::NeedlePath& path) {
  std::vector<bool> fixed(body.mesh.nodes.size(), false);
  for (const std::uint32_t node : body.fixed) fixed[node] = true;
  const anatomy::NeedlePath line{path.entry - before_entry * path.direction(),
                                 path.target + behind_target * path.direction()};
  std::vector<NearNode> near;
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node)
    if (!fixed[node]) near.emplace_back(distance_to(line, body.mesh.nodes[node]), node);
  std::vector<std::uint32_t> nodes = nearest(near, picture_around, most_picture_nodes);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

fem::ElasticBody body_of_picture(const fem::BodyDescription& body, const fem::ContactBody* whole,
                                 const anatomy::NeedlePath& path, const Progress& progress) {
  if (whole == nullptr) return {body, fem::plan_body(body, progress), {}, progress};
  fem::BodyDescription drawn = body;
  drawn.corridor = nodes_of_picture(body, path);
  return {drawn, fem::plan_body(drawn, progress, whole->edges()), {}, progress};
}

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

fem::PointInMesh place_of_node(std::uint32_t node) {
  return {{node, node, node, node}, {1.0, 0.0, 0.0, 0.0}};
}

std::unique_ptr<fem::GrowingField> growing_field(fem::DisplayField field,
                                                 std::shared_ptr<const fem::ContactBody> whole,
                                                 std::vector<fem::PointInMesh> points,
                                                 const fem::LeftNeedleForces& left,
                                                 std::span<const std::uint32_t> node_points) {
  if (whole == nullptr) return std::make_unique<fem::GrowingField>(std::move(field));
  const auto columns = std::make_shared<const fem::NodeColumns>(std::move(whole), std::move(points), left);
  return std::make_unique<fem::GrowingField>(
      std::move(field), [columns](std::span<const std::uint32_t> nodes) { return columns->of(nodes); }, node_points);
}

NodeField::NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body,
                     const anatomy::NeedlePath& path, const Progress& progress, const fem::LeftNeedleForces& left,
                     const std::shared_ptr<const fem::ContactBody>& whole)
    : NodeField(elastic, body, path,
                nodes_of_shaft(elastic, body.mesh, path, hand_around,
                               whole == nullptr ? most_hand_nodes : most_hand_nodes - spare_hand_nodes),
                progress, left, whole) {}

NodeField::NodeField(const fem::ElasticBody& elastic, const fem::BodyDescription& body,
                     const anatomy::NeedlePath& path, const std::vector<std::uint32_t>& pushed,
                     const Progress& progress, const fem::LeftNeedleForces& left,
                     std::shared_ptr<const fem::ContactBody> whole)
    : mesh_nodes_(body.mesh.nodes.size()) {
  const std::size_t spare = whole == nullptr ? 0 : spare_hand_nodes;
  seen_ = nodes_in_sight(body.mesh, path, pushed.size() + spare);
  std::vector<fem::PointInMesh> places = places_of(seen_);
  fem::DisplayField field = fem::display_columns(elastic, places, pushed, progress, left, spare);
  field_ = growing_field(std::move(field), std::move(whole), std::move(places), left, seen_);
  moved_.assign(3 * seen_.size(), 0.0F);
  of_mesh_.assign(3 * mesh_nodes_, 0.0F);
}

std::span<const float> NodeField::evaluate(const fem::NodeForces& forces) {
  field_->evaluate(forces, moved_);
  for (std::size_t i = 0; i < seen_.size(); ++i)
    std::copy_n(moved_.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                of_mesh_.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{seen_[i]}));
  return of_mesh_;
}

}  // namespace bodkin::station
