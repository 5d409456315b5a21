#pragma once

#include <vector>

#include "anatomy/breathing.h"
#include "core/geometry.h"
#include "core/latest_value.h"

namespace bodkin::fem {

// How a body moves by itself, a probe pressing it for example, from the thread that moves it to the needle's tick:
// mm, 3 per node of its mesh; of zero length while it stands still.
using BodyMotion = LatestValue<std::vector<float>>;

// How a body moves as its patient breathes, in a frame that moves along.
struct BodyBreath {
  const anatomy::BreathField* field = nullptr;  // null: nobody breathes
  double drawn_in = 0.0;                        // 0 to 1
  Vec3 of_frame = Vec3::Zero();                 // mm, motion of the frame
};

}  // namespace bodkin::fem
