#pragma once

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin {

using namespace bodkin::anatomy;

// A box of `n` cubes along each axis, each of five tetrahedra, whose tissues are muscle and fat; edges of `edge` mm.
inline TetrahedralMesh block_mesh(int n, double edge) {
  TetrahedralMesh mesh;
  const auto node = [n](int i, int j, int k) { return static_cast<std::uint32_t>((k * (n + 1) + j) * (n + 1) + i); };
  for (int k = 0; k <= n; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) mesh.nodes.emplace_back(0.1 + edge * i, -0.3 + edge * j, 1.0 / 3.0 + edge * k);
    }
  }
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        // Neighbours are mirrored, so that their faces fit.
        const bool odd = (i + j + k) % 2 != 0;
        const auto at = [&](int di, int dj, int dk) { return node(i + (odd ? 1 - di : di), j + dj, k + dk); };
        const std::vector<std::array<std::uint32_t, 4>> five = {{at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)},
                                                                {at(1, 1, 0), at(0, 1, 0), at(1, 0, 0), at(1, 1, 1)},
                                                                {at(1, 0, 1), at(0, 0, 1), at(1, 1, 1), at(1, 0, 0)},
                                                                {at(0, 1, 1), at(1, 1, 1), at(0, 0, 1), at(0, 1, 0)},
                                                                {at(1, 0, 0), at(0, 1, 0), at(0, 0, 1), at(1, 1, 1)}};
        for (auto corners : five) {
          if (odd) std::swap(corners[2], corners[3]);
          mesh.elements.push_back(corners);
          mesh.tissues.push_back(2 * i < n ? tissue::muscle : tissue::fat);
        }
      }
    }
  }
  return mesh;
}

// The mesh in Gmsh's format 2.2, nodes numbered from 11 in steps of 3; regions are the tissues.
inline std::string gmsh_2_text(const TetrahedralMesh& mesh) {
  std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 7 \"outside\"\n3 2 \"fat tissue\"\n"
      "3 3 \"muscle\"\n$EndPhysicalNames\n";
  text += fmt::format("$Nodes\n{}\n", mesh.nodes.size());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    text += fmt::format("{} {} {} {}\n", 11 + 3 * n, mesh.nodes[n].x(), mesh.nodes[n].y(), mesh.nodes[n].z());
  }
  text += fmt::format("$EndNodes\n$Elements\n{}\n1 2 2 7 1 11 14 17\n", mesh.elements.size() + 1);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& corner = mesh.elements[e];
    text += fmt::format("{} 4 2 {} 1 {} {} {} {}\n", e + 2, mesh.tissues[e], 11 + 3 * corner[0], 11 + 3 * corner[1],
                        11 + 3 * corner[2], 11 + 3 * corner[3]);
  }
  return text + "$EndElements\n";
}

// The mesh in Gmsh's format 4.1: one volume per tissue, volume 100 + tissue in the physical group of the tissue; the
// nodes in two blocks, the first one parametric on a surface.
inline std::string gmsh_4_text(const TetrahedralMesh& mesh) {
  std::string text =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 0 1 2\n5 0 0 0 0\n"
      "9 0 0 0 1 1 1 1 7 0\n102 0 0 0 1 1 1 1 2 1 9\n103 0 0 0 1 1 1 2 3 55 1 9\n$EndEntities\n";
  const std::size_t first = mesh.nodes.size() / 2, second = mesh.nodes.size() - first;
  text += fmt::format("$Nodes\n2 {} 1 {}\n2 9 1 {}\n", mesh.nodes.size(), mesh.nodes.size(), first);
  const auto coordinates = [&](std::size_t n) {
    return fmt::format("{} {} {}", mesh.nodes[n].x(), mesh.nodes[n].y(), mesh.nodes[n].z());
  };
  for (std::size_t n = 0; n < first; ++n) text += fmt::format("{}\n", n + 1);
  for (std::size_t n = 0; n < first; ++n) text += coordinates(n) + " 0.5 0.25\n";
  text += fmt::format("3 102 0 {}\n", second);
  for (std::size_t n = first; n < mesh.nodes.size(); ++n) text += fmt::format("{}\n", n + 1);
  for (std::size_t n = first; n < mesh.nodes.size(); ++n) text += coordinates(n) + "\n";
  text += fmt::format("$EndNodes\n$Elements\n3 {} 1 {}\n2 9 2 1\n1 1 2 3\n", mesh.elements.size() + 1,
                      mesh.elements.size() + 1);
  std::size_t number = 2;
  for (const TissueId id : {tissue::fat, tissue::muscle}) {
    std::string lines;
    std::size_t count = 0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      if (mesh.tissues[e] != id) continue;
      const auto& corner = mesh.elements[e];
      lines += fmt::format("{} {} {} {} {}\n", number++, corner[0] + 1, corner[1] + 1, corner[2] + 1, corner[3] + 1);
      ++count;
    }
    text += fmt::format("3 {} 4 {}\n{}", 100 + id, count, lines);
  }
  return text + "$EndElements\n";
}

}  // namespace bodkin
