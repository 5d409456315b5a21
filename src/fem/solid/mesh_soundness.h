#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin::fem {

// Validates a mesh before anything is computed with it. Throws InputError, with the element or node, its position and
// the remedy, when there are no elements, sizes disagree, an index is out of range, a coordinate is not finite, a
// node belongs to no element, an element is inverted or flat (volume below 1e-6 h^3, h its mean edge), or two
// elements have the same corners. For a valid but poorly shaped mesh, with dihedral angles below 5 degrees, returns
// warnings, one sentence each. measure_quality() has the numbers.
std::vector<std::string> check_mesh(const anatomy::TetrahedralMesh& mesh);

// Checks that the fixed nodes hold the whole body. Throws InputError when no node is fixed, when a fixed node is not
// in the mesh, or when a piece of the body, connected through its elements, can still move or turn as a whole because
// fewer than three of its nodes, or only nodes that lie on one line within a thousandth of its length, are fixed. The
// mesh must be valid.
void check_supports(const anatomy::TetrahedralMesh& mesh, std::span<const std::uint32_t> fixed);

}  // namespace bodkin::fem
