#pragma once

#include "anatomy/condensed_body.h"
#include "core/geometry.h"

namespace bodkin::fem {

// Largest stiffness, N/mm, against moving a shaft that holds the contact points of the line from `entry`
// along the unit `direction`, up to `length` mm deep and at most `most_nodes`: the largest eigenvalue of B^T S_AA^-1
// B, where B moves all points equally. 0 without a point. The largest stiffness that a device must render.
double shaft_stiffness(const anatomy::CondensedBody& body, const Vec3& entry, const Vec3& direction, double length,
                       std::size_t most_nodes);

}  // namespace bodkin::fem
