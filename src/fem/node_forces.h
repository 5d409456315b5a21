#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "anatomy/condensed_body.h"

namespace bodkin::fem {

// The force of a needle on one node: of the mesh, or of the body or line of CondensedBody, as the function that
// returns it says.
struct NodeForce {
  std::uint32_t node = 0;
  std::array<float, 3> force{};  // N on the tissue, LPS
};

// All forces of one tick: the display thread's input for drawing the deformed body, small enough to be passed by
// value every tick (core/latest_value.h).
struct NodeForces {
  static constexpr std::size_t most_contacts = 161;  // of a needle: nodes, or points that four nodes carry
  static constexpr std::size_t capacity = 4 * most_contacts;

  std::size_t count = 0;
  std::array<NodeForce, capacity> nodes{};  // capacity; the first `count` are in use
};

// Converts forces on contact points, or on the nodes of a corridor, to nodes of the mesh. A force on a point is
// distributed over the corners of its element, as the point moves with them.
inline NodeForces of_mesh(NodeForces forces, const anatomy::CondensedBody& body) noexcept {
  if (!body.has_contact_points()) {
    for (std::size_t i = 0; i < forces.count; ++i) forces.nodes[i].node = body.mesh_nodes[forces.nodes[i].node];
    return forces;
  }
  NodeForces spread;
  for (std::size_t i = 0; i < forces.count && i < NodeForces::most_contacts; ++i) {
    const anatomy::PlaceInElement& place = body.in_mesh[forces.nodes[i].node];
    for (std::size_t corner = 0; corner < 4; ++corner) {
      if (place.weights[corner] == 0.0) continue;
      const auto share = static_cast<float>(place.weights[corner]);
      const std::array<float, 3>& force = forces.nodes[i].force;
      spread.nodes[spread.count++] = {place.nodes[corner], {share * force[0], share * force[1], share * force[2]}};
    }
  }
  return spread;
}

}  // namespace bodkin::fem
