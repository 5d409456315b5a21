#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "anatomy/condensed_body.h"

namespace bodkin::fem {

// What a needle does to one node: of the corridor, or of the mesh, as who gives it says.
struct NodeForce {
  std::uint32_t node = 0;
  std::array<float, 3> force{};  // N on the tissue, LPS
};

// All of it in one tick: what the graphics thread needs to draw the deformed body, small enough to be handed over by
// value every tick (core/latest_value.h).
struct NodeForces {
  static constexpr std::size_t capacity = 161;

  std::size_t count = 0;
  std::array<NodeForce, capacity> nodes{};  // capacity; the first `count` are in use
};

// Forces on nodes of a corridor, by the nodes of its mesh.
inline NodeForces of_mesh(NodeForces forces, const anatomy::CondensedBody& corridor) noexcept {
  for (std::size_t i = 0; i < forces.count; ++i) forces.nodes[i].node = corridor.mesh_nodes[forces.nodes[i].node];
  return forces;
}

}  // namespace bodkin::fem
