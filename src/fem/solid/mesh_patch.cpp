#include "fem/solid/mesh_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/repeatable.h"

namespace bodkin::fem {

namespace {

using Element = std::array<std::uint32_t, 4>;
using Face = std::array<std::uint32_t, 3>;
constexpr std::uint32_t not_there = std::numeric_limits<std::uint32_t>::max();

Face face_without(const Element& element, std::size_t corner) {
  Face face{element[(corner + 1) % 4], element[(corner + 2) % 4], element[(corner + 3) % 4]};
  std::sort(face.begin(), face.end());
  return face;
}

double signed_volume(const std::vector<Vec3>& nodes, const Element& e) noexcept {
  return (nodes[e[1]] - nodes[e[0]]).cross(nodes[e[2]] - nodes[e[0]]).dot(nodes[e[3]] - nodes[e[0]]) / 6.0;
}

}  // namespace

double edge_of_volume(double volume) noexcept {
  return repeatable::cbrt(6.0 * std::sqrt(2.0) * volume);
}

MeshPatch patch_around(const MeshView& whole, const Vec3& centre, double radius) {
  const anatomy::TetrahedralMesh& mesh = whole.mesh;
  std::vector<bool> near(mesh.nodes.size());
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    near[node] = (mesh.nodes[node] - centre).squaredNorm() <= radius * radius;
  MeshPatch patch;
  std::vector<std::uint32_t> name(mesh.nodes.size(), not_there);
  std::vector<std::uint32_t> rest;  // other elements
  std::set<Face> open;              // faces of one element of the patch
  for (std::uint32_t e = 0; e < mesh.elements.size(); ++e) {
    const Element& element = mesh.elements[e];
    if (std::none_of(element.begin(), element.end(), [&near](std::uint32_t node) { return near[node]; })) {
      rest.push_back(e);
      continue;
    }
    Element taken{};
    for (std::size_t i = 0; i < 4; ++i) {
      std::uint32_t& here = name[element[i]];
      if (here == not_there) {
        here = static_cast<std::uint32_t>(patch.mesh.nodes.size());
        patch.mesh.nodes.push_back(mesh.nodes[element[i]]);
        patch.fixed.push_back(whole.fixed[element[i]]);
      }
      taken[i] = here;
      const Face face = face_without(element, i);
      if (!open.erase(face)) open.insert(face);
    }
    patch.mesh.elements.push_back(taken);
    patch.mesh.tissues.push_back(mesh.tissues[e]);
    patch.quadratic.push_back(whole.quadratic[e]);
  }
  for (const std::uint32_t e : rest) {
    const Element& element = mesh.elements[e];
    const auto shared = std::count_if(element.begin(), element.end(),
                                      [&name](std::uint32_t node) { return name[node] != not_there; });
    if (shared < 3) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const Face face = face_without(element, i);
      if (open.count(face) == 0) continue;
      for (const std::uint32_t node : face) patch.fixed[name[node]] = true;
    }
  }
  return patch;
}

MeshPatch refined(const MeshPatch& patch) {
  MeshPatch fine{{patch.mesh.nodes, {}, {}}, patch.fixed, {}};
  std::vector<Vec3>& nodes = fine.mesh.nodes;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, is_new] =
        middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(nodes.size()));
    if (is_new) {
      const Vec3 place = 0.5 * (nodes[a] + nodes[b]);
      nodes.push_back(place);
      fine.fixed.push_back(patch.fixed[a] && patch.fixed[b]);
    }
    return at->second;
  };
  for (std::size_t e = 0; e < patch.mesh.elements.size(); ++e) {
    const auto [a, b, c, d] = patch.mesh.elements[e];
    const std::uint32_t ab = middle(a, b), ac = middle(a, c), ad = middle(a, d), bc = middle(b, c), bd = middle(b, d),
                        cd = middle(c, d);
    const auto add = [&](Element element) {
      if (signed_volume(nodes, element) < 0.0) std::swap(element[2], element[3]);
      fine.mesh.elements.push_back(element);
      fine.mesh.tissues.push_back(patch.mesh.tissues[e]);
      fine.quadratic.push_back(patch.quadratic[e]);
    };
    add({a, ab, ac, ad});
    add({ab, b, bc, bd});
    add({ac, bc, c, cd});
    add({ad, bd, cd, d});
    // Two opposite midpoints, and the four around them in turn.
    const std::array<std::array<std::uint32_t, 6>, 3> ways = {
        {{ab, cd, ac, ad, bd, bc}, {ac, bd, ab, ad, cd, bc}, {ad, bc, ab, ac, cd, bd}}};
    const auto& way = *std::min_element(ways.begin(), ways.end(), [&nodes](const auto& one, const auto& other) {
      return (nodes[one[0]] - nodes[one[1]]).squaredNorm() < (nodes[other[0]] - nodes[other[1]]).squaredNorm();
    });
    for (std::size_t i = 0; i < 4; ++i) add({way[0], way[1], way[2 + i], way[2 + (i + 1) % 4]});
  }
  return fine;
}

}  // namespace bodkin::fem
