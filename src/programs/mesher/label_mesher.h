#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace bodkin::programs {

// What is to be meshed: labels on a lattice of its own, x = spacing * (i, j, k), and the wanted edge length at every
// voxel. The outermost layer of voxels must be 0.
struct LabelLattice {
  std::array<int, 3> size;           // voxels along i, j, k; i runs fastest; each at least 3
  std::array<double, 3> spacing;     // mm
  std::vector<std::uint8_t> labels;  // size[0] * size[1] * size[2]; 0 = outside
  std::vector<float> edges;          // as many; mm, > 0 where a label or its neighbour is not 0
};

struct LabelMeshing {
  std::size_t fewest = 0;  // nodes; a mesh of fewer or more is not worth improving and is left without elements
  std::size_t most = SIZE_MAX;
  std::size_t expected = 1;  // nodes, for the progress
};

struct LabelMesh {
  std::size_t node_count = 0;                          // of the refined mesh
  std::vector<std::array<double, 3>> nodes;            // mm, on the lattice's axes; empty where the count was missed
  std::vector<std::array<std::uint32_t, 4>> elements;  // positive in VTK's order
  std::vector<std::uint8_t> labels;                    // one per element
};

// Fills the labels with tetrahedra by Delaunay refinement; interfaces between labels become faces of the mesh. Labels
// are taken as smooth between voxels (the label whose trilinear weight is largest). Slivers are perturbed, then
// exuded. One thread; the same input gives the same mesh. This is the only file pair of Bodkin that uses CGAL's
// Mesh_3, which is GPL-3.0-or-later.
LabelMesh mesh_labels(const LabelLattice& lattice, const LabelMeshing& meshing,
                      const std::function<void(const char* stage, double fraction)>& progress);

}  // namespace bodkin::programs
