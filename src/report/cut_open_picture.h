#pragma once

#include <vector>

#include "anatomy/case.h"
#include "core/geometry.h"
#include "imaging/canvas.h"

namespace bodkin::report {

// The patient in 3-D, cut open along the planned path so that what lies on one side of it is seen in relief: bone as
// the CT has it, with the planned path, the target and the way of the tip drawn over it. Rays are cast on all cores.
// `travelled`: LPS mm, in order; it may be empty. `width`, `height`: px. The path must have a length, and the patient
// a CT.
imaging::Canvas cut_open_picture(const anatomy::Case& patient, const anatomy::NeedlePath& path,
                                 const std::vector<Vec3>& travelled, double width, double height);

}  // namespace bodkin::report
