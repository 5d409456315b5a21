#pragma once

#include "anatomy/ultrasound_probe.h"
#include "core/geometry.h"

namespace bodkin::imaging {

// A probe's pose with its face's middle at `face`, looking along `depth` (need not be unit), its marked side as near
// as may be to `marked`. Throws InputError when a direction is zero or both are parallel.
Pose probe_pose(const Vec3& face, const Vec3& depth, const Vec3& marked);

}  // namespace bodkin::imaging
