#include "fem/solid/quadratic_edges.h"

#include <algorithm>
#include <map>

#include "fem/solid/elastic_assembly.h"

namespace bodkin::fem {

namespace {

constexpr double softer = 0.5;     // Young's modulus of what lies below a stiff skin, by the skin's
constexpr double as_large = 0.75;  // the smaller of two areas by the larger

// A face of an element, its nodes ascending.
struct ElementFace {
  std::array<std::uint32_t, 3> nodes{};
  std::uint32_t element = 0;
  bool operator<(const ElementFace& other) const noexcept {
    return nodes != other.nodes ? nodes < other.nodes : element < other.element;
  }
};

std::vector<ElementFace> faces_in_order(const anatomy::TetrahedralMesh& mesh) {
  std::vector<ElementFace> faces;
  faces.reserve(4 * mesh.elements.size());
  for (std::uint32_t element = 0; element < mesh.elements.size(); ++element) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const auto& nodes = mesh.elements[element];
      ElementFace face{{nodes[(corner + 1) % 4], nodes[(corner + 2) % 4], nodes[(corner + 3) % 4]}, element};
      std::sort(face.nodes.begin(), face.nodes.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

double area_of(const anatomy::TetrahedralMesh& mesh, const ElementFace& face) noexcept {
  const Vec3 &a = mesh.nodes[face.nodes[0]], &b = mesh.nodes[face.nodes[1]], &c = mesh.nodes[face.nodes[2]];
  return 0.5 * (b - a).cross(c - a).norm();
}

// The faces of elements that are free to move at the surface of the body, and those on tissues that are softer.
struct FacesOfTissues {
  std::vector<ElementFace> free, on_softer;
};

FacesOfTissues faces_of_tissues(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
                                const std::vector<bool>& fixed) {
  const std::vector<ElementFace> all = faces_in_order(mesh);
  FacesOfTissues faces;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i + 1 == all.size() || all[i].nodes != all[i + 1].nodes) {
      if (!std::ranges::all_of(all[i].nodes, [&fixed](std::uint32_t node) { return fixed[node]; }))
        faces.free.push_back(all[i]);
      continue;
    }
    const double here = materials.find(mesh.tissues[all[i].element])->young,
                 there = materials.find(mesh.tissues[all[i + 1].element])->young;
    if (there <= softer * here) faces.on_softer.push_back(all[i]);
    if (here <= softer * there) faces.on_softer.push_back(all[i + 1]);
    ++i;
  }
  return faces;
}

// Of a tissue, mm^2.
struct SkinAreas {
  double free = 0.0, on_softer = 0.0;
  double below_surface = 0.0;  // of on_softer, no more than two elements below the surface

  bool are_of_skin() const noexcept {
    return free > 0.0 && below_surface >= as_large * free && as_large * on_softer <= free;
  }
};

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
  const FacesOfTissues faces = faces_of_tissues(mesh, materials, fixed);
  std::vector<bool> at_surface(mesh.nodes.size(), false);
  for (const ElementFace& face : faces.free)
    for (const std::uint32_t node : face.nodes) at_surface[node] = true;
  const auto touches = [&mesh](std::size_t element, const std::vector<bool>& nodes) {
    return std::ranges::any_of(mesh.elements[element], [&nodes](std::uint32_t node) { return nodes[node]; });
  };
  std::vector<bool> of_surface = at_surface;  // the nodes of all elements there
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    if (!touches(element, at_surface)) continue;
    for (const std::uint32_t node : mesh.elements[element]) of_surface[node] = true;
  }
  std::map<anatomy::TissueId, SkinAreas> areas;
  for (const ElementFace& face : faces.free) areas[mesh.tissues[face.element]].free += area_of(mesh, face);
  for (const ElementFace& face : faces.on_softer) {
    SkinAreas& of_tissue = areas[mesh.tissues[face.element]];
    of_tissue.on_softer += area_of(mesh, face);
    if (touches(face.element, of_surface)) of_tissue.below_surface += area_of(mesh, face);
  }
  std::vector<bool> chosen(mesh.elements.size(), false);
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    const auto found = areas.find(mesh.tissues[element]);
    chosen[element] = found != areas.end() && found->second.are_of_skin() && touches(element, of_surface);
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
