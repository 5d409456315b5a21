#pragma once

#include <vector>

#include "scene/marks.h"

#include "anatomy/ultrasound_probe.h"

namespace bodkin::app {

// The position of a probe and its field of view down to `depth` mm, as lines, LPS mm: first the border of its image,
// then its head as a box of the width of its face. `pose`: probe to patient.
std::vector<scene::Trail> probe_outline(const anatomy::UltrasoundProbe& probe, double depth, const Pose& pose);

}  // namespace bodkin::app
