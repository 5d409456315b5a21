#pragma once

#include <array>
#include <cstddef>

#include "anatomy/grid.h"

namespace bodkin::patient {

// A CT lattice with every voxel divided into whole parts.
struct TissueLattice {
  anatomy::Grid grid;
  std::array<int, 3> parts = {1, 1, 1};  // tissue voxels per CT voxel along i, j, k
};

// Divides each axis of `ct` by the smallest whole number that leaves no voxel edge longer than `spacing` (mm, > 0; 5
// % over is tolerated). The faces of CT voxels stay faces of tissue voxels. If that gives more than `most` voxels,
// the axis with the shortest edges is divided less, until it fits or nothing can be reduced.
TissueLattice divide_lattice(const anatomy::Grid& ct, double spacing, std::size_t most = 200'000'000);

}  // namespace bodkin::patient
