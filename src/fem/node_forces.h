#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace bodkin {

// What a needle does to one node of the corridor.
struct NodeForce {
  std::uint32_t node = 0;        // of the corridor
  std::array<float, 3> force{};  // N on the tissue, LPS
};

// All of it in one tick: what the graphics thread needs to draw the deformed body, small enough to be handed over by
// value every tick (core/latest_value.h).
struct NodeForces {
  static constexpr std::size_t capacity = 161;

  std::size_t count = 0;
  std::array<NodeForce, capacity> nodes{};  // capacity; the first `count` are in use
};

}  // namespace bodkin
