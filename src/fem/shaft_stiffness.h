#pragma once

#include "anatomy/condensed_body.h"
#include "core/geometry.h"

namespace bodkin::fem {

// N/mm against moving a shaft that holds the contact points of the line from `entry` along the unit `direction`, up
// to `length` mm deep and at most `most_nodes`: the largest eigenvalue of B^T S_AA^-1 B, B moving all of them alike.
// 0 when there is no point. What a device must render at worst.
double shaft_stiffness(const anatomy::CondensedBody& body, const Vec3& entry, const Vec3& direction, double length,
                       std::size_t most_nodes);

}  // namespace bodkin::fem
