#pragma once

#include <array>

#include "patient/from_ct/morphology.h"

#include "anatomy/volume.h"

namespace bodkin::patient {

// Filters with which a person corrects one structure of a segmentation. CT and mask lie on one lattice.

// Nothing farther than `reach` mm from the voxel `seed` is taken; 0: no limit.
struct SegmentReach {
  std::array<int, 3> seed = {0, 0, 0};
  double reach = 0.0;
};

// The voxels from `low` to `high` HU. Throws InputError for a range the wrong way round or a seed outside.
MaskVolume threshold_region(const anatomy::CtVolume& ct, int low, int high, const SegmentReach& within);

// Those of them that hang together with the seed through voxel faces. Throws InputError also when the seed is not in
// the range, with its HU.
MaskVolume grown_region(const anatomy::CtVolume& ct, int low, int high, const SegmentReach& from);

// Between two slices across `axis` (0 to 2) that hold voxels, the slices without any take the shape where the
// linearly interpolated signed distances to the two outlines are not above zero (Raya and Udupa 1990, shape-based
// interpolation). Slices that hold voxels stay as they are. Throws InputError when there are no two such slices.
MaskVolume filled_between_slices(const MaskVolume& mask, int axis);

// Where the mask, blurred by a Gaussian of `radius` mm, is at least one half: plane surfaces stay, corners and what
// is smaller than the radius go. Throws InputError for a radius that is not above 0, and when the image is thinner
// than four voxels.
MaskVolume smoothed(const MaskVolume& mask, double radius);

}  // namespace bodkin::patient
