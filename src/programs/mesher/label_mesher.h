#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace bodkin::programs {

// The input: labels on a separate lattice, x = spacing * (i, j, k), and the desired edge length at every voxel. The
// outermost layer of voxels must be 0.
struct LabelLattice {
  std::array<int, 3> size;           // voxels along i, j, k; i runs fastest; each at least 3
  std::array<double, 3> spacing;     // mm
  std::vector<std::uint8_t> labels;  // size[0] * size[1] * size[2]; 0 = outside
  std::vector<float> edges;          // as many; mm, > 0 where a label or its neighbour is not 0
};

struct LabelMeshing {
  std::size_t fewest = 0;  // nodes; a mesh with a count outside this range is not improved and gets no elements
  std::size_t most = SIZE_MAX;
  std::size_t expected = 1;  // nodes, for the progress bar
};

struct LabelMesh {
  std::size_t node_count = 0;                          // of the refined mesh
  std::vector<std::array<double, 3>> nodes;            // mm, on the lattice's axes; empty: count out of range
  std::vector<std::array<std::uint32_t, 4>> elements;  // positive in VTK's order
  std::vector<std::uint8_t> labels;                    // one per element
};

// Fills the labels with tetrahedra by Delaunay refinement; interfaces between labels become faces of the mesh. Labels
// are interpolated between voxels (the label with the largest trilinear weight). Slivers are perturbed, then exuded.
// One thread; the same input gives the same mesh. Only this file pair of Bodkin uses CGAL's Mesh_3, which is
// GPL-3.0-or-later.
LabelMesh mesh_labels(const LabelLattice& lattice, const LabelMeshing& meshing,
                      const std::function<void(const char* stage, double fraction)>& progress);

}  // namespace bodkin::programs
