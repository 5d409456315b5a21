#pragma once

#include "core/geometry.h"

namespace bodkin {

// The rotation by the smallest angle that takes the direction of `from` to that of `to`; neither is zero. For
// opposite directions it is one of the half turns. Not inline, because Eigen decomposes a matrix for that case.
Eigen::Quaterniond shortest_turn(const Vec3& from, const Vec3& to);

}  // namespace bodkin
