#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin {

// Where points lie in a mesh, so that they move with it: the four corners of an element and the weight of each.
struct PointInMesh {
  std::array<std::uint32_t, 4> nodes{};
  std::array<double, 4> weights{};  // 0 to 1, sum 1; all 0 for a point that is too far from the mesh to move with it
  bool moves() const noexcept { return weights[0] + weights[1] + weights[2] + weights[3] > 0.5; }
};

// Finds the element of each point (LPS mm). A point outside the mesh, as skin is that the mesh has rounded off, moves
// with the closest place of the closest element within `reach` mm; one further away does not move. The mesh must be
// sound (check_mesh).
std::vector<PointInMesh> find_points(const TetrahedralMesh& mesh, std::span<const Vec3> points, double reach = 5.0);

}  // namespace bodkin
