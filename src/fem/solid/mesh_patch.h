#pragma once

#include <cstdint>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin::fem {

// A part of a mesh with its fixed nodes, and the elements in which displacements are quadratic.
struct MeshPatch {
  anatomy::TetrahedralMesh mesh;
  std::vector<bool> fixed;      // one per node
  std::vector<bool> quadratic;  // one per element
};

// The whole mesh from which patches are taken.
struct MeshView {
  const anatomy::TetrahedralMesh& mesh;
  const std::vector<bool>& fixed;      // one per node
  const std::vector<bool>& quadratic;  // one per element
};

// The elements with a corner within `radius` mm of `centre`. Its border with the rest of the mesh is held in addition
// to the nodes fixed already; the surface of the body stays free. May be empty.
MeshPatch patch_around(const MeshView& whole, const Vec3& centre, double radius);

// The same patch with every tetrahedron cut into eight, its octahedron along its shortest diagonal. The linear
// displacements of the patch are among those of the refined one. The middle of an edge between two fixed nodes is
// fixed. The pieces of an element with quadratic displacements have them too.
MeshPatch refined(const MeshPatch& patch);

// mm, the edge of a regular tetrahedron of this volume (mm^3).
double edge_of_volume(double volume) noexcept;

}  // namespace bodkin::fem
