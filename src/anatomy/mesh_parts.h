#pragma once

#include <cstddef>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin::anatomy {

// Keeps only the largest part of a mesh that is connected by faces of tetrahedra, and the nodes that it uses, in
// their order. Returns the number of elements removed. Corners must be nodes.
std::size_t keep_largest_part(TetrahedralMesh& mesh);

// Volume of element `e`, mm^3; positive when its corners are in the order of TetrahedralMesh.
double element_volume(const TetrahedralMesh& mesh, std::size_t e);

// Reorders every element of negative volume. Returns their number.
std::size_t orient_elements(TetrahedralMesh& mesh);

}  // namespace bodkin::anatomy
