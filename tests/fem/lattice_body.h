#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/random.h"
#include "fem/solid/elastic_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;

// A box of n[0] x n[1] x n[2] nodes with edges of `sides` mm, from the origin: every cell is cut into the six
// tetrahedra around its diagonal (Kuhn). Nodes inside are moved by up to `jitter` of a cell in each direction.
inline TetrahedralMesh kuhn_box(const std::array<std::uint32_t, 3>& n, const Vec3& sides, double jitter = 0.0,
                                std::uint64_t seed = 1) {
  constexpr std::array<std::array<std::uint32_t, 2>, 6> turns = {{{0, 1}, {1, 2}, {2, 0}, {0, 2}, {2, 1}, {1, 0}}};
  TetrahedralMesh mesh;
  Random random(seed);
  const Vec3 cell(sides.x() / (n[0] - 1), sides.y() / (n[1] - 1), sides.z() / (n[2] - 1));
  for (std::uint32_t k = 0; k < n[2]; ++k) {
    for (std::uint32_t j = 0; j < n[1]; ++j) {
      for (std::uint32_t i = 0; i < n[0]; ++i) {
        Vec3 node(i * cell.x(), j * cell.y(), k * cell.z());
        const bool inside = i > 0 && j > 0 && k > 0 && i + 1 < n[0] && j + 1 < n[1] && k + 1 < n[2];
        if (inside && jitter > 0.0)
          for (Eigen::Index axis = 0; axis < 3; ++axis) node[axis] += jitter * cell[axis] * random.uniform(-1.0, 1.0);
        mesh.nodes.push_back(node);
      }
    }
  }
  const auto name = [&n](const std::array<std::uint32_t, 3>& at) { return (at[2] * n[1] + at[1]) * n[0] + at[0]; };
  for (std::uint32_t k = 0; k + 1 < n[2]; ++k) {
    for (std::uint32_t j = 0; j + 1 < n[1]; ++j) {
      for (std::uint32_t i = 0; i + 1 < n[0]; ++i) {
        for (const auto& turn : turns) {
          std::array<std::uint32_t, 3> at{i, j, k};
          std::array<std::uint32_t, 4> element{name(at)};
          ++at[turn[0]];
          element[1] = name(at);
          ++at[turn[1]];
          element[2] = name(at);
          element[3] = name({i + 1, j + 1, k + 1});
          const bool even = (turn[0] + 1) % 3 == turn[1];
          if (!even) std::swap(element[1], element[2]);
          mesh.elements.push_back(element);
          mesh.tissues.push_back(tissue::soft);
        }
      }
    }
  }
  return mesh;
}

// The same with n nodes and `side` mm along each axis.
inline TetrahedralMesh kuhn_lattice(std::uint32_t n, double side, double jitter = 0.0, std::uint64_t seed = 1) {
  return kuhn_box({n, n, n}, Vec3::Constant(side), jitter, seed);
}

inline ElasticMaterials soft_and_ligament() {
  ElasticMaterials materials;  // Sutherland et al. 2013, Table I
  materials.set(tissue::soft, {0.020, 0.3});
  materials.set(tissue::ligamentum_flavum, {0.170, 0.3});
  return materials;
}

// The `count` free nodes that lie nearest to the middle line of the box, from its top face down.
inline std::vector<std::uint32_t> nodes_around_middle(const BodyDescription& body, double side, std::size_t count) {
  std::vector<bool> fixed(body.mesh.nodes.size(), false);
  for (const std::uint32_t node : body.fixed) fixed[node] = true;
  std::vector<std::pair<double, std::uint32_t>> near;
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
    const Vec3& x = body.mesh.nodes[node];
    if (!fixed[node] && x.z() >= 0.2 * side)
      near.emplace_back(std::hypot(x.x() - 0.5 * side, x.y() - 0.5 * side), node);
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min(count, near.size()));
  std::vector<std::uint32_t> nodes;
  for (const auto& [distance, node] : near) nodes.push_back(node);
  return nodes;
}

// What a box of `side` mm is made of and held by: soft tissue with a slab of ligament across it, its bottom, z = 0.
inline void layers_of_ligament(BodyDescription& body, double side) {
  for (std::size_t element = 0; element < body.mesh.elements.size(); ++element) {
    double z = 0.0;
    for (const std::uint32_t node : body.mesh.elements[element]) z += 0.25 * body.mesh.nodes[node].z() / side;
    if (z > 0.4 && z < 0.6) body.mesh.tissues[element] = tissue::ligamentum_flavum;
  }
  body.materials = soft_and_ligament();
  body.fixed = nodes_beyond(body.mesh, Vec3::Zero(), Vec3(0.0, 0.0, -1.0));
}

// A box of soft tissue with a slab of ligament across it, held at its bottom, z = 0, and a corridor down its middle.
inline BodyDescription lattice_body(std::uint32_t n, double side, double jitter, std::size_t corridor,
                                    std::uint64_t seed = 1) {
  BodyDescription body;
  body.mesh = kuhn_lattice(n, side, jitter, seed);
  layers_of_ligament(body, side);
  body.corridor = nodes_around_middle(body, side, corridor);
  return body;
}

}  // namespace bodkin
