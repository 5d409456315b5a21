#pragma once

#include <vector>

#include "anatomy/case.h"
#include "core/geometry.h"
#include "imaging/canvas.h"

namespace bodkin::report {

// An ultrasound probe in the picture: where the middle of its face went, and the edges of its slice at one time, LPS
// mm. Both empty: there was none.
struct ProbeWay {
  std::vector<Vec3> face, slice;
};

// The patient in 3-D, cut open along the planned path so that what lies on one side of it is seen in relief: bone as
// the CT has it, with the planned path, the target, the way of the tip and the probe drawn over it. Rays are cast on
// all cores. `travelled`: LPS mm, in order; it may be empty. `width`, `height`: px. The path must have a length, and
// the patient a CT.
imaging::Canvas cut_open_picture(const anatomy::Case& patient, const anatomy::NeedlePath& path,
                                 const std::vector<Vec3>& travelled, double width, double height,
                                 const ProbeWay& probe = {});

}  // namespace bodkin::report
