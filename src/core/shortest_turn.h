#pragma once

#include "core/geometry.h"

namespace bodkin {

// The turn by the smallest angle that takes the direction of `from` to that of `to`; neither is zero. Of opposite
// directions one of the half turns. Compiled once: Eigen decomposes a matrix for that case.
Eigen::Quaterniond shortest_turn(const Vec3& from, const Vec3& to);

}  // namespace bodkin
