#include "fem/solid/quadratic_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "fem/solid/elastic_assembly.h"

namespace bodkin::fem {

namespace {

constexpr double softer = 0.5;    // Young's modulus below a stiff skin, over the skin's
constexpr double covering = 0.5;  // of a skin's free surface, that lies above softer tissue
constexpr double no_layer = 2.0;  // minimum border, by free surface, of tissue that only ends at the surface
constexpr double parallel = 0.7;  // cosine between the skin's two sides
constexpr int most_elements = 3;  // in the thickness of a skin; with more, linear ones bend well enough

using Face = std::array<std::uint32_t, 3>;  // nodes, ascending

struct ElementFace {
  Face nodes{};
  std::uint32_t element = 0;
  bool operator<(const ElementFace& other) const noexcept {
    return nodes != other.nodes ? nodes < other.nodes : element < other.element;
  }
};

Face face_opposite(const std::array<std::uint32_t, 4>& element, std::size_t corner) {
  Face face{element[(corner + 1) % 4], element[(corner + 2) % 4], element[(corner + 3) % 4]};
  std::sort(face.begin(), face.end());
  return face;
}

// Pairs of tissues in the mesh of which one is much softer.
std::set<anatomy::TissueId> stiff_tissues(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials) {
  const std::set<anatomy::TissueId> all(mesh.tissues.begin(), mesh.tissues.end());
  double least = std::numeric_limits<double>::infinity();
  for (const anatomy::TissueId tissue : all) least = std::min(least, materials.find(tissue)->young);
  std::set<anatomy::TissueId> stiff;
  for (const anatomy::TissueId tissue : all)
    if (least <= softer * materials.find(tissue)->young) stiff.insert(tissue);
  return stiff;
}

// Faces of elements of stiff tissues: free ones at the surface of the body, and those on a much softer tissue.
struct StiffFaces {
  std::vector<ElementFace> free, on_softer;
};

StiffFaces faces_of_stiff_tissues(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
                                  const std::vector<bool>& fixed) {
  const std::set<anatomy::TissueId> stiff = stiff_tissues(mesh, materials);
  std::vector<ElementFace> all, border;
  for (std::uint32_t element = 0; element < mesh.elements.size(); ++element) {
    if (!stiff.contains(mesh.tissues[element])) continue;
    for (std::size_t corner = 0; corner < 4; ++corner)
      all.push_back({face_opposite(mesh.elements[element], corner), element});
  }
  std::sort(all.begin(), all.end());
  StiffFaces faces;
  const auto young = [&](std::uint32_t element) { return materials.find(mesh.tissues[element])->young; };
  std::vector<bool> at_border(mesh.nodes.size(), false);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i + 1 < all.size() && all[i].nodes == all[i + 1].nodes) {
      const double here = young(all[i].element), there = young(all[i + 1].element);
      if (there <= softer * here) faces.on_softer.push_back(all[i]);
      if (here <= softer * there) faces.on_softer.push_back(all[i + 1]);
      ++i;
      continue;
    }
    border.push_back(all[i]);
    for (const std::uint32_t node : all[i].nodes) at_border[node] = true;
  }
  std::vector<bool> is_inside(border.size(), false);  // an element of another tissue is behind it
  for (std::uint32_t element = 0; element < mesh.elements.size(); ++element) {
    const auto& corners = mesh.elements[element];
    if (stiff.contains(mesh.tissues[element])) continue;
    if (std::ranges::count_if(corners, [&at_border](std::uint32_t node) { return at_border[node]; }) < 3) continue;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Face face = face_opposite(corners, corner);
      const auto found = std::ranges::lower_bound(border, face, {}, &ElementFace::nodes);
      if (found == border.end() || found->nodes != face) continue;
      is_inside[static_cast<std::size_t>(found - border.begin())] = true;
      if (young(element) <= softer * young(found->element)) faces.on_softer.push_back(*found);
    }
  }
  for (std::size_t i = 0; i < border.size(); ++i) {
    const bool held = std::ranges::all_of(border[i].nodes, [&fixed](std::uint32_t node) { return fixed[node]; });
    if (!is_inside[i] && !held) faces.free.push_back(border[i]);
  }
  return faces;
}

// mm^2, outward normal of the face, as long as its area.
Vec3 area_of(const anatomy::TetrahedralMesh& mesh, const ElementFace& face) {
  const Vec3 &a = mesh.nodes[face.nodes[0]], &b = mesh.nodes[face.nodes[1]], &c = mesh.nodes[face.nodes[2]];
  const Vec3 area = 0.5 * (b - a).cross(c - a);
  Vec3 middle = Vec3::Zero();
  for (const std::uint32_t node : mesh.elements[face.element]) middle += 0.25 * mesh.nodes[node];
  return area.dot(a - middle) < 0.0 ? Vec3(-area) : area;
}

// By node: direction of the surface of a stiff tissue, at its nodes and at those up to `most_elements` below it in
// the same tissue; zero elsewhere.
std::vector<Vec3> outwards(const anatomy::TetrahedralMesh& mesh, const std::vector<ElementFace>& surface) {
  std::vector<Vec3> found(mesh.nodes.size(), Vec3::Zero());
  std::set<anatomy::TissueId> at_surface;
  for (const ElementFace& face : surface) {
    at_surface.insert(mesh.tissues[face.element]);
    for (const std::uint32_t node : face.nodes) found[node] += area_of(mesh, face);
  }
  for (int below = 0; below < most_elements; ++below) {
    const std::vector<Vec3> above = found;
    for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
      if (!at_surface.contains(mesh.tissues[element])) continue;
      Vec3 sum = Vec3::Zero();
      for (const std::uint32_t node : mesh.elements[element]) sum += above[node];
      for (const std::uint32_t node : mesh.elements[element])
        if (above[node].isZero(0.0)) found[node] += sum;
    }
  }
  return found;
}

}  // namespace

QuadraticEdges::QuadraticEdges(const anatomy::TetrahedralMesh& mesh, const std::vector<bool>& quadratic,
                               const std::vector<bool>& fixed)
    : first_unknown_(static_cast<std::uint32_t>(std::count(fixed.begin(), fixed.end(), false))) {
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    if (!quadratic[element]) continue;
    const auto& nodes = mesh.elements[element];
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = a + 1; b < 4; ++b) {
        if (!fixed[nodes[a]] || !fixed[nodes[b]])
          ends_.push_back({std::min(nodes[a], nodes[b]), std::max(nodes[a], nodes[b])});
      }
    }
  }
  if (ends_.empty()) return;
  std::sort(ends_.begin(), ends_.end());
  ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
  start_.assign(mesh.nodes.size() + 1, 0);
  for (const auto& [smaller, larger] : ends_) ++start_[smaller + 1];
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) start_[node + 1] += start_[node];
}

std::uint32_t QuadraticEdges::unknown(std::uint32_t a, std::uint32_t b) const noexcept {
  if (ends_.empty()) return none;
  const auto [smaller, larger] = std::minmax(a, b);
  const auto first = ends_.begin() + start_[smaller], last = ends_.begin() + start_[smaller + 1];
  const auto found = std::lower_bound(first, last, std::array<std::uint32_t, 2>{smaller, larger});
  if (found == last || (*found)[1] != larger) return none;
  return first_unknown_ + static_cast<std::uint32_t>(found - ends_.begin());
}

std::vector<bool> elements_of_stiff_skin(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
                                         const std::vector<bool>& fixed) {
  std::vector<bool> chosen(mesh.elements.size(), false);
  const StiffFaces faces = faces_of_stiff_tissues(mesh, materials, fixed);
  if (faces.free.empty() || faces.on_softer.empty()) return chosen;
  const std::vector<Vec3> out = outwards(mesh, faces.free);
  struct Areas {  // mm^2
    double free = 0.0, on_softer = 0.0, covered = 0.0;
    bool are_of_skin() const noexcept {
      return free > 0.0 && covered >= covering * free && on_softer <= no_layer * free;
    }
  };
  std::map<anatomy::TissueId, Areas> areas;
  for (const ElementFace& face : faces.free) areas[mesh.tissues[face.element]].free += area_of(mesh, face).norm();
  for (const ElementFace& face : faces.on_softer) {
    const Vec3 area = area_of(mesh, face), above = out[face.nodes[0]] + out[face.nodes[1]] + out[face.nodes[2]];
    Areas& of_tissue = areas[mesh.tissues[face.element]];
    of_tissue.on_softer += area.norm();
    if (std::abs(area.dot(above)) > parallel * area.norm() * above.norm()) of_tissue.covered += area.norm();
  }
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    const auto found = areas.find(mesh.tissues[element]);
    if (found == areas.end() || !found->second.are_of_skin()) continue;
    chosen[element] =
        std::ranges::all_of(mesh.elements[element], [&out](std::uint32_t node) { return !out[node].isZero(0.0); });
  }
  return chosen;
}

CarriedPoint carried_point(std::span<const PointInMesh> places, std::span<const std::uint32_t> free_nodes,
                           const QuadraticEdges& edges) {
  std::map<std::uint32_t, double> shares;
  const auto count = static_cast<double>(places.size());
  for (const PointInMesh& place : places) {
    if (!place.moves()) continue;
    for (std::size_t a = 0; a < 4; ++a) {
      const std::uint32_t free = free_nodes[place.nodes[a]];
      if (free != ElasticSystem::fixed && place.weights[a] != 0.0) shares[free] += place.weights[a] / count;
      for (std::size_t b = a + 1; b < 4; ++b) {
        const double weight = 4.0 * place.weights[a] * place.weights[b];
        if (weight == 0.0) continue;
        const std::uint32_t edge = edges.unknown(place.nodes[a], place.nodes[b]);
        if (edge != QuadraticEdges::none) shares[edge] += weight / count;
      }
    }
  }
  CarriedPoint point;
  for (const auto& [unknown, weight] : shares) point.shares.push_back({unknown, weight});
  return point;
}

}  // namespace bodkin::fem
