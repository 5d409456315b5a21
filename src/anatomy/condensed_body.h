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

// A place in an element of a mesh, which moves with its corners.
struct PlaceInElement {
  std::array<std::uint32_t, 4> nodes{};  // of the mesh
  std::array<double, 4> weights{};       // of each, sum 1
};

// A deformable body as the needle sees it: the contact points of one line through it (fem::ContactBody), in their
// order from the entry on, which are no nodes of the mesh, or, of `closest_node`, the nodes of its corridor; and how
// each of them moves by a force on any of them, exactly as in the whole body with what is fixed held fixed.
struct CondensedBody {
  std::vector<Vec3> nodes;                   // mm, LPS, at rest
  std::vector<std::uint32_t> mesh_nodes;     // what they are called in the mesh; none for contact points
  std::vector<TissueId> tissues;             // of the stiffest element that a node belongs to
  Eigen::MatrixXd compliance;                // mm/N; symmetric, 3 rows and columns a node, x y z in turn
  std::vector<PlaceInElement> in_mesh = {};  // of contact points; else none

  bool has_contact_points() const noexcept { return !in_mesh.empty(); }
};

// A body prepared for needles along a path.
struct PreparedBody {
  std::shared_ptr<const CondensedBody> body;  // nullptr: none
  NeedlePath path;                            // that it was prepared about
};

}  // namespace bodkin::anatomy
