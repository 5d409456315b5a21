#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "anatomy/tissue.h"
#include "core/geometry.h"

namespace bodkin {

// A deformable body as the needle sees it: the nodes of its corridor, and how each of them moves by a force on any of
// them, exactly as in the whole body with what is fixed held fixed.
struct CondensedBody {
  std::vector<Vec3> nodes;                // mm, LPS, at rest
  std::vector<std::uint32_t> mesh_nodes;  // what they are called in the mesh
  std::vector<TissueId> tissues;          // of the stiffest element that a node belongs to
  Eigen::MatrixXd compliance;             // mm/N; symmetric, 3 rows and columns a node, x y z in turn
};

}  // namespace bodkin
