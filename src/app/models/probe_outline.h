#pragma once

#include <vector>

#include "scene/marks.h"

#include "anatomy/ultrasound_probe.h"

namespace bodkin::app {

// Where a probe is held and what it sees down to `depth` mm, as lines, LPS mm: first the border of its picture, then
// its head, seen as a box of the width of its face. `pose`: probe to patient.
std::vector<scene::Trail> probe_outline(const anatomy::UltrasoundProbe& probe, double depth, const Pose& pose);

}  // namespace bodkin::app
