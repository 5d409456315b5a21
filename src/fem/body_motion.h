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

// The displacement of a body that moves independently of the needle, for example under a probe.
struct BodyField {
  std::uint64_t step = 0;    // of the body, after which this was its displacement; 0: at rest, before the first step
  std::vector<float> moved;  // mm, 3 per node of its mesh; empty while it stands still
  // The first `held_count` of `held`: nodes of the mesh that the probe holds. `held` has room for all nodes that it
  // can hold, and never grows.
  std::vector<std::uint32_t> held;
  std::size_t held_count = 0;
  std::uint64_t held_since = 0;  // step in which a node was last captured or released

  std::span<const std::uint32_t> held_nodes() const noexcept { return {held.data(), held_count}; }
};

// From the body thread to the needle's tick.
using BodyMotion = LatestValue<BodyField>;

// The input of a step of a body, and the digest of its result.
struct BodyStep {
  std::uint64_t step = 0;     // from 1 on, without a gap
  std::optional<Pose> probe;  // the probe that pressed the body; empty: none
  std::uint64_t digest = 0;   // of BodyField::moved
};

// From the body thread to the recorder.
using BodySteps = SingleProducerRing<BodyStep>;

// How a breathing patient's body moves, in a frame that moves with it.
struct BodyBreath {
  const anatomy::BreathField* field = nullptr;  // null: no breathing
  double drawn_in = 0.0;                        // 0 to 1
  Vec3 of_frame = Vec3::Zero();                 // mm, motion of the frame
};

}  // namespace bodkin::fem
