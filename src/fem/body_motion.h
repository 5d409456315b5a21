#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "anatomy/breathing.h"
#include "core/geometry.h"
#include "core/latest_value.h"
#include "core/single_producer_ring.h"

namespace bodkin::fem {

// Where a body has moved by itself, a probe pressing it for example.
struct BodyField {
  std::uint64_t step = 0;    // of the body, after which it lay so; 0: at rest, before the first
  std::vector<float> moved;  // mm, 3 per node of its mesh; of zero length while it stands still
  // The first `held_count` of `held`: nodes of the mesh that the probe holds. `held` has room for all that it could
  // hold, and never grows.
  std::vector<std::uint32_t> held;
  std::size_t held_count = 0;
  std::uint64_t held_since = 0;  // step that took or released one last

  std::span<const std::uint32_t> held_nodes() const noexcept { return {held.data(), held_count}; }
};

// From the thread that moves the body to the needle's tick.
using BodyMotion = LatestValue<BodyField>;

// What determines a step of a body, given those before it, and what came of it.
struct BodyStep {
  std::uint64_t step = 0;     // from 1 on, without a gap
  std::optional<Pose> probe;  // that pressed the body; none: none
  std::uint64_t digest = 0;   // of BodyField::moved
};

// From the thread that moves the body to whoever records it.
using BodySteps = SingleProducerRing<BodyStep>;

// How a body moves as its patient breathes, in a frame that moves along.
struct BodyBreath {
  const anatomy::BreathField* field = nullptr;  // null: nobody breathes
  double drawn_in = 0.0;                        // 0 to 1
  Vec3 of_frame = Vec3::Zero();                 // mm, motion of the frame
};

}  // namespace bodkin::fem
