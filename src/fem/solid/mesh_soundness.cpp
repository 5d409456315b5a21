#include "fem/solid/mesh_soundness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "anatomy/mesh_parts.h"
#include "anatomy/mesh_quality.h"
#include "core/error.h"
#include "fem/solid/mesh_place.h"

namespace bodkin::fem {

namespace {

constexpr double flattest = 1e-6;     // volume of an element over the cube of its mean edge
constexpr double poor_angle = 5.0;    // degrees
constexpr double on_one_line = 1e-3;  // distance from a line over its length; less holds only a millionth as well

constexpr std::array<std::array<std::size_t, 2>, 6> edges = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

using Corners = std::array<Vec3, 4>;

Corners corners_of(const anatomy::TetrahedralMesh& mesh, std::size_t element) {
  Corners corners;
  for (std::size_t corner = 0; corner < 4; ++corner) corners[corner] = mesh.nodes[mesh.elements[element][corner]];
  return corners;
}

void check_indices(const anatomy::TetrahedralMesh& mesh) {
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

void refuse_flat(const anatomy::TetrahedralMesh& mesh, std::size_t element, double volume, double edge) {
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

void refuse_repeated(const anatomy::TetrahedralMesh& mesh) {
  using Key = std::array<std::uint32_t, 4>;
  std::vector<std::pair<Key, std::uint32_t>> keys;
  keys.reserve(mesh.elements.size());
  for (std::uint32_t element = 0; element < mesh.elements.size(); ++element) {
    Key key;
    std::copy_n(mesh.elements[element].begin(), 4, key.begin());
    std::sort(key.begin(), key.end());
    keys.emplace_back(key, element);
  }
  std::sort(keys.begin(), keys.end());
  const auto same = [](const auto& one, const auto& other) { return one.first == other.first; };
  const auto twice = std::adjacent_find(keys.begin(), keys.end(), same);
  if (twice == keys.end()) return;
  throw InputError(
      fmt::format("elements {} and {} at {} have the same four corners, so that the body would be twice as stiff "
                  "there; remove one of them",
                  twice->second, std::next(twice)->second, place_of_element(mesh, twice->second)));
}

// The connected pieces of a mesh: a union-find over nodes.
class Pieces {
 public:
  explicit Pieces(const anatomy::TetrahedralMesh& mesh) : parent_(mesh.nodes.size()) {
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

// The fixed nodes of one piece, as many as show that they hold it.
struct Support {
  std::vector<std::uint32_t> nodes;  // up to three, not on one line
  void add(const anatomy::TetrahedralMesh& mesh, std::uint32_t node) {
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

std::vector<std::string> check_mesh(const anatomy::TetrahedralMesh& mesh) {
  check_indices(mesh);
  std::size_t poor_elements = 0, poorest = 0;
  double smallest_angle = poor_angle;
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    const Corners x = corners_of(mesh, element);
    double sum = 0.0;
    for (const auto& [a, b] : edges) sum += (x[b] - x[a]).norm();
    refuse_flat(mesh, element, anatomy::element_volume(mesh, element), sum / 6.0);
    const std::array<double, 6> angles = anatomy::dihedral_angles(x[0], x[1], x[2], x[3]);
    const double angle = *std::min_element(angles.begin(), angles.end());
    if (angle >= poor_angle) continue;
    ++poor_elements;
    if (angle >= smallest_angle) continue;
    smallest_angle = angle;
    poorest = element;
  }
  refuse_repeated(mesh);
  if (poor_elements == 0) return {};
  return {fmt::format(
      "{} of {} elements have a dihedral angle below {} degrees, the smallest is {:.2f} in element {} at {}; the "
      "body is used, but is stiffer there than its tissue",
      poor_elements, mesh.elements.size(), poor_angle, smallest_angle, poorest, place_of_element(mesh, poorest))};
}

void check_supports(const anatomy::TetrahedralMesh& mesh, std::span<const std::uint32_t> fixed) {
  if (fixed.empty()) {
    throw InputError(
        "no node of the body is fixed, so that any force would carry it away; fix its bone or its far side");
  }
  Pieces pieces(mesh);
  std::vector<Support> supports(mesh.nodes.size());  // by first node of a piece
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
    const std::string what = supports[node].nodes.empty()
                                 ? "none of its nodes is fixed"
                                 : "its fixed nodes lie on one line or nearly so, so that it can turn";
    throw InputError(
        fmt::format("a piece of the body with {} nodes, node {} at {} among them, is not held: {}; fix three "
                    "nodes of it that are not on one line, or mesh the body without it",
                    size, node, place_of(mesh.nodes[node]), what));
  }
}

}  // namespace bodkin::fem
