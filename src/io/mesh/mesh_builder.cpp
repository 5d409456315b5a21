#include "io/mesh/mesh_builder.h"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::io {

void MeshBuilder::add_node(const Vec3& point, const std::string& where) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (std::abs(point[axis]) <= furthest_mesh_node) continue;  // false for NaN
    throw InputError(fmt::format("{}: node {} has the coordinate {:g}, expected numbers within {:g} mm", where,
                                 mesh_.nodes.size() + 1, point[axis], furthest_mesh_node));
  }
  mesh_.nodes.push_back(point);
}

void MeshBuilder::add_element(const std::array<std::uint32_t, 4>& corners, std::int64_t region,
                              const std::string& name, const std::string& where) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (corners[i] >= mesh_.nodes.size()) {
      throw InputError(fmt::format("{}: {} has the node at position {}, but there are only {} nodes", where, name,
                                   corners[i], mesh_.nodes.size()));
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (corners[i] != corners[j]) continue;
      throw InputError(fmt::format("{}: {} has one node twice, expected four different ones", where, name));
    }
  }
  mesh_.elements.push_back(corners);
  mesh_.regions.push_back(region);
}

ForeignMesh MeshBuilder::finish(const std::string& origin) {
  if (mesh_.elements.empty()) throw InputError(fmt::format("{}: there are no tetrahedra in this mesh", origin));
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh_.nodes.size(), unused);
  for (const auto& element : mesh_.elements) {
    for (const std::uint32_t node : element) number[node] = 0;
  }
  std::vector<Vec3> used;
  for (std::size_t node = 0; node < number.size(); ++node) {
    if (number[node] == unused) continue;
    number[node] = static_cast<std::uint32_t>(used.size());
    used.push_back(mesh_.nodes[node]);
  }
  if (const std::size_t idle = mesh_.nodes.size() - used.size(); idle > 0) {
    mesh_.notes.push_back(fmt::format("{} nodes that no tetrahedron uses were left out.", idle));
    for (auto& element : mesh_.elements) {
      for (std::uint32_t& node : element) node = number[node];
    }
    mesh_.nodes = std::move(used);
  }
  return std::move(mesh_);
}

}  // namespace bodkin::io
