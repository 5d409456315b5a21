#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "anatomy/tissue.h"
#include "core/geometry.h"

namespace bodkin::anatomy {

// A body as linear tetrahedra. Indices are into `nodes`; corners are ordered so that the volume is positive: the
// fourth lies on the side of the first three from which they run anticlockwise (VTK's order).
struct TetrahedralMesh {
  std::vector<Vec3> nodes;  // mm, LPS, at rest
  std::vector<std::array<std::uint32_t, 4>> elements;
  std::vector<TissueId> tissues;  // one per element
};

}  // namespace bodkin::anatomy
