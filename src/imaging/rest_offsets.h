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

  // LPS mm of all, x fastest.
  std::vector<Vec3> points() const;
};

// Where at rest that lies which now is at each point of a lattice.
struct RestOffsets {
  PointLattice lattice;        // at least two points along each axis
  std::vector<float> offsets;  // mm, x y z of each point in turn: from the point to where it lies
};

}  // namespace bodkin::imaging
