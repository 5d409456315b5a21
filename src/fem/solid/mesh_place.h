#pragma once

#include <cstddef>
#include <string>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin::fem {

// A position, for sentences: "(1.0, -2.5, 30.0) mm".
std::string place_of(const Vec3& point);
// The middle of an element, whose indices must be in range.
Vec3 middle_of_element(const anatomy::TetrahedralMesh& mesh, std::size_t element);
std::string place_of_element(const anatomy::TetrahedralMesh& mesh, std::size_t element);

}  // namespace bodkin::fem
