#pragma once

#include <vector>

#include "core/latest_value.h"

namespace bodkin::fem {

// How a body moves by itself, a probe pressing it for example, from the thread that moves it to the needle's tick:
// mm, 3 per node of its mesh; of zero length while it stands still.
using BodyMotion = LatestValue<std::vector<float>>;

}  // namespace bodkin::fem
