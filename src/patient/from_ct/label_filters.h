#pragma once

#include <array>

#include "patient/from_ct/morphology.h"

#include "anatomy/volume.h"

namespace bodkin::patient {

// Filters with which a person corrects one structure of a segmentation. CT and mask lie on one lattice.

// Nothing farther than `reach` mm from the voxel `seed` is included; 0: no limit.
struct SegmentReach {
  std::array<int, 3> seed = {0, 0, 0};
  double reach = 0.0;
};

// The voxels from `low` to `high` HU. Throws InputError for an inverted range or a seed outside.
MaskVolume threshold_region(const anatomy::CtVolume& ct, int low, int high, const SegmentReach& within);

// Those connected to the seed through voxel faces. Also throws InputError, with the seed's HU, when the seed is not
// in the range.
MaskVolume grown_region(const anatomy::CtVolume& ct, int low, int high, const SegmentReach& from);

// Between two slices across `axis` (0 to 2) that contain voxels, the empty slices get the shape where the linearly
// interpolated signed distances to the two outlines are not above zero (Raya and Udupa 1990, shape-based
// interpolation). Slices with voxels are not changed. Throws InputError when there are no two such slices.
MaskVolume filled_between_slices(const MaskVolume& mask, int axis);

// The voxels where the mask, blurred by a Gaussian of `radius` mm, is at least one half: plane surfaces stay, corners
// and objects smaller than the radius disappear. Throws InputError for a radius that is not above 0, and when the
// image is thinner than four voxels.
MaskVolume smoothed(const MaskVolume& mask, double radius);

}  // namespace bodkin::patient
