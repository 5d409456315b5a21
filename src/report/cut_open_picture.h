#pragma once

#include <vector>

#include "anatomy/case.h"
#include "core/geometry.h"
#include "imaging/canvas.h"

namespace bodkin::report {

// An ultrasound probe in the image: the path of the middle of its face, and the edges of its slice at one time, LPS
// mm. Both empty: no probe.
struct ProbePath {
  std::vector<Vec3> face, slice;
};

// The patient in 3-D, cut open along the planned path so that one side of it is seen in relief: bone from the CT,
// with the planned path, the target, the path of the tip and the probe drawn over it. Rays are cast on all cores.
// `travelled`: LPS mm, in order; it may be empty. `width`, `height`: px. The path must have a length, and the patient
// a CT.
imaging::Canvas cut_open_picture(const anatomy::Case& patient, const anatomy::NeedlePath& path,
                                 const std::vector<Vec3>& travelled, double width, double height,
                                 const ProbePath& probe = {});

}  // namespace bodkin::report
