#pragma once

#include "anatomy/ultrasound_probe.h"
#include "core/geometry.h"

namespace bodkin::imaging {

// A probe's pose with its face's middle at `face`, looking along `depth` (not necessarily unit), its orientation
// marker as close as possible to `marked`. Throws InputError when a direction is zero or both are parallel.
Pose probe_pose(const Vec3& face, const Vec3& depth, const Vec3& marked);

}  // namespace bodkin::imaging
