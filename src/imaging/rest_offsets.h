#pragma once

#include <array>
#include <vector>

#include "core/geometry.h"

namespace bodkin::imaging {

// Points on a lattice along the patient's axes.
struct PointLattice {
  Vec3 corner = Vec3::Zero();           // LPS mm, the point with the least coordinates
  double spacing = 5.0;                 // mm
  std::array<int, 3> size = {0, 0, 0};  // points along x, y and z

  // LPS mm of all points, x fastest.
  std::vector<Vec3> points() const;
};

// The positions at rest of the tissue that is now at the points of a lattice.
struct RestOffsets {
  PointLattice lattice;        // at least two points along each axis
  std::vector<float> offsets;  // mm, x y z of each point: from the point to its position at rest
};

}  // namespace bodkin::imaging
