#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin::fem {

// The position of a point in a mesh, with which it moves: the four corners of an element and the weight of each.
struct PointInMesh {
  std::array<std::uint32_t, 4> nodes{};
  std::array<double, 4> weights{};  // 0 to 1, sum 1; all 0 for a point that is too far from the mesh to move with it
  std::uint32_t element = 0;        // of the mesh; only for a point that moves
  bool moves() const noexcept { return weights[0] + weights[1] + weights[2] + weights[3] > 0.5; }
};

// Finds the element of each point (LPS mm). A point outside the mesh, for example on skin that the mesh has rounded
// off, moves with the closest point of the closest element within `reach` mm; a point farther away does not move. The
// mesh must be valid (check_mesh).
std::vector<PointInMesh> find_points(const anatomy::TetrahedralMesh& mesh, std::span<const Vec3> points,
                                     double reach = 5.0);

// As find_points(), for repeated requests: it keeps a search structure of the mesh, which must outlive it.
class PointFinder {
 public:
  explicit PointFinder(const anatomy::TetrahedralMesh& mesh);
  ~PointFinder();
  PointFinder(const PointFinder&) = delete;
  PointFinder& operator=(const PointFinder&) = delete;

  PointInMesh find(const Vec3& point, double reach = 5.0) const;

 private:
  class Grid;
  const anatomy::TetrahedralMesh& mesh_;
  std::unique_ptr<const Grid> grid_;  // null for a mesh without elements
};

}  // namespace bodkin::fem
