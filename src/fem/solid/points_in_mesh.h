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

// Where points lie in a mesh, so that they move with it: the four corners of an element and the weight of each.
struct PointInMesh {
  std::array<std::uint32_t, 4> nodes{};
  std::array<double, 4> weights{};  // 0 to 1, sum 1; all 0 for a point that is too far from the mesh to move with it
  std::uint32_t element = 0;        // of the mesh; of a point that moves
  bool moves() const noexcept { return weights[0] + weights[1] + weights[2] + weights[3] > 0.5; }
};

// Finds the element of each point (LPS mm). A point outside the mesh, as skin is that the mesh has rounded off, moves
// with the closest place of the closest element within `reach` mm; one further away does not move. The mesh must be
// sound (check_mesh).
std::vector<PointInMesh> find_points(const anatomy::TetrahedralMesh& mesh, std::span<const Vec3> points,
                                     double reach = 5.0);

// The same for points that are asked for again and again: it keeps what it knows of the mesh, which must outlive it.
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
  std::unique_ptr<const Grid> grid_;  // none of a mesh without elements
};

}  // namespace bodkin::fem
