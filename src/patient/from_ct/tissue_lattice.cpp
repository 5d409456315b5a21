#include "patient/from_ct/tissue_lattice.h"

#include <algorithm>
#include <cmath>

namespace bodkin::patient {

TissueLattice divide_lattice(const anatomy::Grid& ct, double spacing, std::size_t most) {
  constexpr double forgiven = 1.05;
  TissueLattice lattice;
  auto& parts = lattice.parts;
  for (int axis = 0; axis < 3; ++axis) {
    const double edges = ct.spacing[axis] / (spacing * forgiven);
    parts[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(std::ceil(edges - 1e-9)));
  }
  const auto voxels = [&] {
    double count = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) count *= static_cast<double>(ct.size[axis]) * parts[axis];
    return count;
  };
  while (voxels() > static_cast<double>(most)) {
    int shortest = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis), s = static_cast<std::size_t>(shortest);
      if (parts[a] == 1) continue;
      if (shortest < 0 || ct.spacing[axis] / parts[a] < ct.spacing[shortest] / parts[s]) shortest = axis;
    }
    if (shortest < 0) break;
    --parts[static_cast<std::size_t>(shortest)];
  }

  lattice.grid = ct;
  Vec3 first;  // index in the CT of the centre of the first tissue voxel
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    lattice.grid.size[a] = ct.size[a] * parts[a];
    lattice.grid.spacing[axis] = ct.spacing[axis] / parts[a];
    first[axis] = 0.5 / parts[a] - 0.5;
  }
  lattice.grid.origin = ct.to_patient(first);
  return lattice;
}

}  // namespace bodkin::patient
