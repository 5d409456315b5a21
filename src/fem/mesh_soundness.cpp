#include "fem/mesh_soundness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "core/error.h"
#include "fem/mesh_place.h"

namespace bodkin {

namespace {

constexpr double flattest = 1e-6;     // volume of an element over the cube of its mean edge
constexpr double poor_angle = 5.0;    // degrees
constexpr double on_one_line = 1e-6;  // distance from a line, over its length

constexpr std::array<std::array<std::size_t, 2>, 6> edges = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

using Corners = std::array<Vec3, 4>;

Corners corners_of(const TetrahedralMesh& mesh, std::size_t element) {
  Corners corners;
  for (std::size_t corner = 0; corner < 4; ++corner) corners[corner] = mesh.nodes[mesh.elements[element][corner]];
  return corners;
}

void check_indices(const TetrahedralMesh& mesh) {
  if (mesh.elements.empty()) throw InputError("the mesh has no elements; expected at least one tetrahedron");
  if (mesh.tissues.size() != mesh.elements.size()) {
    throw InputError(fmt::format("the mesh has {} elements but {} tissues, expected one tissue per element",
                                 mesh.elements.size(), mesh.tissues.size()));
  }
  if (mesh.nodes.size() >= std::numeric_limits<std::uint32_t>::max() / 3) {
    throw InputError(
        fmt::format("the mesh has {} nodes, more than can be numbered; mesh more coarsely", mesh.nodes.size()));
  }
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    if (mesh.nodes[node].allFinite()) continue;
    const Vec3& p = mesh.nodes[node];
    throw InputError(
        fmt::format("node {} of the mesh lies at ({}, {}, {}), expected finite coordinates in mm; write "
                    "the mesh anew",
                    node, p.x(), p.y(), p.z()));
  }
  std::vector<bool> used(mesh.nodes.size(), false);
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    for (const std::uint32_t node : mesh.elements[element]) {
      if (node >= mesh.nodes.size()) {
        throw InputError(
            fmt::format("element {} has the corner {}, but the nodes of the mesh are 0 to {}; write the "
                        "mesh anew, with indices from 0",
                        element, node, mesh.nodes.size() - 1));
      }
      used[node] = true;
    }
  }
  const auto loose = std::find(used.begin(), used.end(), false);
  if (loose != used.end()) {
    const auto node = static_cast<std::size_t>(loose - used.begin());
    throw InputError(
        fmt::format("node {} at {} belongs to no element ({} such nodes in all); remove what the elements "
                    "do not use",
                    node, place_of(mesh.nodes[node]), std::count(used.begin(), used.end(), false)));
  }
}

// Degrees, between the two faces that meet in each edge: in the plane across the edge, the angle between the
// directions to the other two corners.
std::array<double, 6> dihedral_angles(const Corners& x) {
  std::array<double, 6> angles{};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [a, b] = edges[i];
    const auto [c, d] = edges[5 - i];  // the opposite edge
    const Vec3 along = (x[b] - x[a]).normalized();
    const Vec3 to_c = (x[c] - x[a]) - along * along.dot(x[c] - x[a]);
    const Vec3 to_d = (x[d] - x[a]) - along * along.dot(x[d] - x[a]);
    angles[i] = std::atan2(to_c.cross(to_d).norm(), to_c.dot(to_d)) / degree;
  }
  return angles;
}

void refuse_flat(const TetrahedralMesh& mesh, std::size_t element, double volume, double edge) {
  const double least = flattest * edge * edge * edge;
  if (volume >= least) return;
  if (volume <= -least) {
    throw InputError(
        fmt::format("element {} at {} is inverted, its volume is {:.3g} mm^3; exchange two of its corners "
                    "so that the fourth lies on the side from which the first three run anticlockwise",
                    element, place_of_element(mesh, element), volume));
  }
  throw InputError(
      fmt::format("element {} at {} is flat: {:.3g} mm^3 for edges of {:.3g} mm, expected at least {:.0e} "
                  "of their cube; let the mesher remove slivers (perturb and exude) or mesh anew",
                  element, place_of_element(mesh, element), volume, edge, flattest));
}

// Counts the nodes of each tissue, without a set per tissue: nodes sorted by tissue, each pair once.
void count_tissue_nodes(const TetrahedralMesh& mesh, MeshQuality& quality) {
  std::vector<std::uint32_t> last_seen(mesh.nodes.size());
  for (std::size_t tissue = 0; tissue < 256; ++tissue) {
    if (quality.tissue_elements[tissue] == 0) continue;
    const auto mark = static_cast<std::uint32_t>(tissue + 1);
    for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
      if (mesh.tissues[element] != tissue) continue;
      for (const std::uint32_t node : mesh.elements[element]) {
        if (last_seen[node] != mark) ++quality.tissue_nodes[tissue];
        last_seen[node] = mark;
      }
    }
  }
}

// The pieces of a mesh that hang together through elements: a union-find over nodes.
class Pieces {
 public:
  explicit Pieces(const TetrahedralMesh& mesh) : parent_(mesh.nodes.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const auto& element : mesh.elements)
      for (std::size_t corner = 1; corner < 4; ++corner) join(element[0], element[corner]);
  }
  // The smallest node of the piece.
  std::uint32_t of(std::uint32_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }

 private:
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> parent_;
};

// The fixed nodes of one piece, as far as needed to see that they hold it.
struct Support {
  std::vector<std::uint32_t> nodes;  // up to three, not on one line
  void add(const TetrahedralMesh& mesh, std::uint32_t node) {
    if (nodes.size() == 3) return;
    const Vec3& x = mesh.nodes[node];
    if (!nodes.empty() && (x - mesh.nodes[nodes[0]]).norm() == 0.0) return;
    if (nodes.size() == 2) {
      const Vec3 along = mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]], to = x - mesh.nodes[nodes[0]];
      if (along.cross(to).norm() <= on_one_line * along.norm() * std::max(along.norm(), to.norm())) return;
    }
    nodes.push_back(node);
  }
};

}  // namespace

MeshQuality check_mesh(const TetrahedralMesh& mesh) {
  check_indices(mesh);
  MeshQuality quality;
  quality.nodes = mesh.nodes.size();
  quality.elements = mesh.elements.size();
  quality.smallest_angle = 180.0;
  quality.smallest_volume = quality.shortest_edge = std::numeric_limits<double>::infinity();
  double edge_sum = 0.0;
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    const Corners x = corners_of(mesh, element);
    const double volume = (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) / 6.0;
    double sum = 0.0;
    for (const auto& [a, b] : edges) {
      const double length = (x[b] - x[a]).norm();
      sum += length;
      quality.shortest_edge = std::min(quality.shortest_edge, length);
      quality.longest_edge = std::max(quality.longest_edge, length);
    }
    refuse_flat(mesh, element, volume, sum / 6.0);
    edge_sum += sum;
    quality.volume += volume;
    quality.smallest_volume = std::min(quality.smallest_volume, volume);
    quality.largest_volume = std::max(quality.largest_volume, volume);
    quality.tissue_volume[mesh.tissues[element]] += volume;
    ++quality.tissue_elements[mesh.tissues[element]];
    const std::array<double, 6> angles = dihedral_angles(x);
    for (const double angle : angles) {
      ++quality.angles[std::min<std::size_t>(35, static_cast<std::size_t>(angle / 5.0))];
      quality.largest_angle = std::max(quality.largest_angle, angle);
      if (angle >= quality.smallest_angle) continue;
      quality.smallest_angle = angle;
      quality.smallest_angle_element = element;
    }
    if (*std::min_element(angles.begin(), angles.end()) < poor_angle) ++quality.poor_elements;
  }
  quality.mean_edge = edge_sum / (6.0 * static_cast<double>(quality.elements));
  count_tissue_nodes(mesh, quality);
  if (quality.poor_elements > 0) {
    quality.warnings.push_back(fmt::format(
        "{} of {} elements have a dihedral angle below {} degrees, the smallest is {:.2f} in element {} at {}; the "
        "body is used, but is stiffer there than its tissue",
        quality.poor_elements, quality.elements, poor_angle, quality.smallest_angle, quality.smallest_angle_element,
        place_of_element(mesh, quality.smallest_angle_element)));
  }
  return quality;
}

void check_supports(const TetrahedralMesh& mesh, std::span<const std::uint32_t> fixed) {
  if (fixed.empty()) {
    throw InputError(
        "no node of the body is fixed, so that any force would carry it away; fix its bone or its far side");
  }
  Pieces pieces(mesh);
  std::vector<Support> supports(mesh.nodes.size());  // by the first node of a piece
  for (const std::uint32_t node : fixed) {
    if (node >= mesh.nodes.size()) {
      throw InputError(
          fmt::format("node {} is to be fixed, but the nodes of the mesh are 0 to {}", node, mesh.nodes.size() - 1));
    }
    supports[pieces.of(node)].add(mesh, node);
  }
  for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
    if (pieces.of(node) != node || supports[node].nodes.size() == 3) continue;
    std::size_t size = 0;
    for (std::uint32_t other = node; other < mesh.nodes.size(); ++other) size += pieces.of(other) == node ? 1 : 0;
    const std::string what = supports[node].nodes.empty() ? "none of its nodes is fixed"
                                                          : "its fixed nodes lie on one line, so that it can turn";
    throw InputError(
        fmt::format("a piece of the body with {} nodes, node {} at {} among them, is not held: {}; fix three "
                    "nodes of it that are not on one line, or mesh the body without it",
                    size, node, place_of(mesh.nodes[node]), what));
  }
}

}  // namespace bodkin
