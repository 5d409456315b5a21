#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
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

// A deformable body as the needle sees it: the nodes of its corridor, and how each of them moves by a force on any of
// them, exactly as in the whole body with what is fixed held fixed. Or the contact points of one line through it
// (fem::ContactBody), in their order from the entry on, which are no nodes of the mesh.
struct CondensedBody {
  std::vector<Vec3> nodes;                   // mm, LPS, at rest
  std::vector<std::uint32_t> mesh_nodes;     // what they are called in the mesh; none for contact points
  std::vector<TissueId> tissues;             // of the stiffest element that a node belongs to
  Eigen::MatrixXd compliance;                // mm/N; symmetric, 3 rows and columns a node, x y z in turn
  std::vector<PlaceInElement> in_mesh = {};  // of contact points; else none

  bool has_contact_points() const noexcept { return !in_mesh.empty(); }
};

// A corridor that a needle can be put into.
struct PreparedCorridor {
  std::shared_ptr<const CondensedBody> body;  // nullptr: none
  NeedlePath path;                            // that it was prepared about
  // The tick of the session whose needle aimed along `path`; nothing for the corridor that the session began with.
  std::optional<std::uint64_t> aimed_at;
  // 0: the body at rest, as it was prepared. Else the number of another state of the body, in which its nodes are
  // where they are in that state.
  std::uint32_t state = 0;
  // Of another state: where the same nodes are at rest. Empty: they are those of the session's first corridor.
  std::vector<Vec3> at_rest = {};
};

// Marks the nodes of a corridor that are marked in another one of the same mesh. The mesh nodes of both must ascend;
// marks are one a node.
inline void take_marks(const CondensedBody& body, std::vector<std::uint8_t>& marks, const CondensedBody& other,
                       const std::vector<std::uint8_t>& other_marks) noexcept {
  std::size_t from = 0;
  for (std::size_t node = 0; node < marks.size(); ++node) {
    while (from < other_marks.size() && other.mesh_nodes[from] < body.mesh_nodes[node]) ++from;
    if (from == other_marks.size()) return;
    if (other.mesh_nodes[from] == body.mesh_nodes[node] && other_marks[from] != 0) marks[node] = 1;
  }
}

}  // namespace bodkin::anatomy
