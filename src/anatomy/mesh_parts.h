#pragma once

#include <cstddef>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin::anatomy {

// Leaves only the largest part of a mesh that hangs together by faces of tetrahedra, and the nodes that it uses, in
// their order. Returns how many elements were taken away. Corners must be nodes.
std::size_t keep_largest_part(TetrahedralMesh& mesh);

// Volume of element `e`, mm^3; positive when its corners are ordered as TetrahedralMesh wants them.
double element_volume(const TetrahedralMesh& mesh, std::size_t e);

// Turns every element of negative volume. Returns how many there were.
std::size_t orient_elements(TetrahedralMesh& mesh);

}  // namespace bodkin::anatomy
