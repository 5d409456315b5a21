#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "anatomy/needle_path.h"
#include "anatomy/tissue.h"
#include "core/geometry.h"

namespace bodkin::anatomy {

// A point in an element of a mesh; it moves with the element's corners.
struct PlaceInElement {
  std::array<std::uint32_t, 4> nodes{};  // of the mesh
  std::array<double, 4> weights{};       // of each node; their sum is 1
};

// A deformable body condensed for the needle. Its nodes are the contact points of one line through the body
// (fem::ContactBody), in their order from the entry, which are not nodes of the mesh; or, for `closest_node`, the
// nodes of its corridor. The compliance is exactly that of the whole body with its fixed nodes held.
struct CondensedBody {
  std::vector<Vec3> nodes;                   // mm, LPS, at rest
  std::vector<std::uint32_t> mesh_nodes;     // their indices in the mesh; empty for contact points
  std::vector<TissueId> tissues;             // of the stiffest element that contains the node
  Eigen::MatrixXd compliance;                // mm/N; symmetric, 3 rows and columns (x, y, z) per node
  std::vector<PlaceInElement> in_mesh = {};  // of contact points; otherwise empty

  bool has_contact_points() const noexcept { return !in_mesh.empty(); }
};

// A body prepared for needles along a path.
struct PreparedBody {
  std::shared_ptr<const CondensedBody> body;  // nullptr: none
  NeedlePath path;                            // about which it was prepared
};

}  // namespace bodkin::anatomy
