#pragma once

#include "views/frame.h"

#include "training/plan.h"

namespace bodkin::app {

using namespace views;

// The part of a frame that views may show in a stage of a training plan. Without the overlay there is no planned path
// and no target; without the ladder the tip's tissue has no name and no colour; without the needle it is not drawn,
// and slices do not follow it. Spans stay those of `frame`.
Frame allowed_frame(const Frame& frame, const training::PlanAids& aids);

}  // namespace bodkin::app
