#pragma once

#include "patient/synthetic/model.h"

namespace bodkin::patient {

// A midline lumbar puncture between the spinous processes of vertebra `upper` and the next one.
struct Approach {
  anatomy::NeedlePath path;
  double clearance = 0.0;  // mm from the path to the nearest bone; negative: it passes through bone
  double angle = 0.0;      // rad that the needle points towards the head
};

// The path to the middle of the dural sac with the largest clearance to bone, up to 5 mm; among equals the one
// closest to the usual slight angle towards the head.
Approach plan_approach(const LumbarModel& model, int upper);

}  // namespace bodkin::patient
