#include "anatomy/mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "anatomy/mesh_parts.h"
#include "core/repeatable.h"

namespace bodkin::anatomy {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 6> edges_of = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
// The corners that are not on an edge, in the order of edges_of.
constexpr std::array<std::array<std::size_t, 2>, 6> others_of = {{{2, 3}, {1, 3}, {1, 2}, {0, 3}, {0, 2}, {0, 1}}};
constexpr double degrees_per_bin = 180.0 / angle_bins;
constexpr double poor_angle = 10.0;  // degrees

// Between the parts of (c - a) and (d - a) that are perpendicular to the edge b - a; the tangent keeps its accuracy
// for the flattest of angles.
double angle_at(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 edge = b - a;
  const double length = edge.norm();
  if (length == 0.0) return 0.0;
  const Vec3 n = edge.cross(c - a), m = edge.cross(d - a);
  return repeatable::atan2(n.cross(m).norm(), n.dot(m)) / degree;
}

void measure_elements(const TetrahedralMesh& mesh, MeshQuality& quality) {
  std::array<TissueMesh, 256> tissues{};
  quality.smallest_volume = quality.smallest_angle = std::numeric_limits<double>::infinity();
  quality.largest_volume = -quality.smallest_volume;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const double volume = element_volume(mesh, e);
    quality.volume += volume;
    quality.smallest_volume = std::min(quality.smallest_volume, volume);
    quality.largest_volume = std::max(quality.largest_volume, volume);
    if (!(volume > 0.0)) ++quality.not_positive;
    TissueMesh& own = tissues[mesh.tissues[e]];
    ++own.elements;
    own.volume += volume;
    const auto& corner = mesh.elements[e];
    const auto angles =
        dihedral_angles(mesh.nodes[corner[0]], mesh.nodes[corner[1]], mesh.nodes[corner[2]], mesh.nodes[corner[3]]);
    for (const double angle : angles) {
      ++quality.angles[static_cast<std::size_t>(
          std::clamp<int>(static_cast<int>(angle / degrees_per_bin), 0, angle_bins - 1))];
    }
    const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
    quality.smallest_angle = std::min(quality.smallest_angle, *low);
    quality.largest_angle = std::max(quality.largest_angle, *high);
    if (*low < poor_angle) ++quality.below_10;
  }
  for (std::size_t id = 0; id < tissues.size(); ++id) {
    if (tissues[id].elements == 0) continue;
    tissues[id].tissue = static_cast<TissueId>(id);
    quality.tissues.push_back(tissues[id]);
  }
}

void count_nodes(const TetrahedralMesh& mesh, MeshQuality& quality) {
  std::vector<std::pair<TissueId, std::uint32_t>> uses;
  uses.reserve(4 * mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (const std::uint32_t node : mesh.elements[e]) uses.emplace_back(mesh.tissues[e], node);
  }
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  for (TissueMesh& own : quality.tissues) {
    own.nodes = static_cast<std::size_t>(
        std::count_if(uses.begin(), uses.end(), [&](const auto& use) { return use.first == own.tissue; }));
  }
}

void measure_edges(const TetrahedralMesh& mesh, const std::function<bool(const Vec3&)>& in_region,
                   MeshQuality& quality) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(6 * mesh.elements.size());
  for (const auto& corner : mesh.elements) {
    for (const auto& ends : edges_of) edges.push_back(std::minmax(corner[ends[0]], corner[ends[1]]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  double sum = 0.0, sum_in_region = 0.0;
  std::size_t in = 0;
  quality.shortest_edge = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : edges) {
    const double length = (mesh.nodes[b] - mesh.nodes[a]).norm();
    sum += length;
    quality.shortest_edge = std::min(quality.shortest_edge, length);
    quality.longest_edge = std::max(quality.longest_edge, length);
    if (!in_region || !in_region(0.5 * (mesh.nodes[a] + mesh.nodes[b]))) continue;
    sum_in_region += length;
    ++in;
  }
  quality.mean_edge = sum / static_cast<double>(edges.size());
  if (in > 0) quality.mean_edge_in_region = sum_in_region / static_cast<double>(in);
}

}  // namespace

std::array<double, 6> dihedral_angles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
  const std::array<const Vec3*, 4> corner = {&a, &b, &c, &d};
  std::array<double, 6> angles;
  for (std::size_t i = 0; i < 6; ++i) {
    angles[i] = angle_at(*corner[edges_of[i][0]], *corner[edges_of[i][1]], *corner[others_of[i][0]],
                         *corner[others_of[i][1]]);
  }
  return angles;
}

MeshQuality measure_quality(const TetrahedralMesh& mesh, const std::function<bool(const Vec3&)>& in_region) {
  MeshQuality quality;
  quality.nodes = mesh.nodes.size();
  quality.elements = mesh.elements.size();
  if (mesh.elements.empty()) return quality;
  measure_elements(mesh, quality);
  count_nodes(mesh, quality);
  measure_edges(mesh, in_region, quality);
  if (in_region) {
    quality.nodes_in_region =
        static_cast<std::size_t>(std::count_if(mesh.nodes.begin(), mesh.nodes.end(), in_region));
  }
  return quality;
}

}  // namespace bodkin::anatomy
