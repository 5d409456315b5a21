#pragma once

#include <bitset>

#include "anatomy/surface.h"
#include "anatomy/tissue.h"
#include "anatomy/volume.h"

namespace bodkin::anatomy {

// A set of tissues.
using TissueSet = std::bitset<256>;

// Everything but the air around the patient: the surface of this set is the skin.
TissueSet body_tissues();
// Cortical and cancellous bone: the surface of this set is the bone that a needle meets.
TissueSet bone_tissues();

// Resolution of a surface. [D] our choice; the defaults are for skin, use 1 and 1 mm for bone.
struct TissueSurfaceSettings {
  double edge = 2.0;       // mm, desired edge of the cells of the sampling lattice; 0.2 to 20 [D]
  double smoothing = 2.0;  // mm, standard deviation of the Gaussian that smooths the steps of the voxels; 0 to 10 [D]
};

// The surface of the voxels made of `region`, LPS mm, closed: a region that the image cuts off gets a flat lid there.
//
// The fraction of `region` is averaged over whole blocks of voxels of about `edge`, smoothed, and contoured at one
// half, with one vertex per mixed cell at the mean of the crossings of the cell's edges (surface nets; Gibson 1998).
// Places where the region touches itself only in an edge or a corner are filled first, so that every edge has two
// triangles and every vertex one fan. A sheet thinner than about 1.35 times the smoothing is lost, and a surface of
// radius R moves inwards by about smoothing^2 / R. Throws InputError for settings out of range, for an empty volume,
// and when no voxel of `region` is left.
Surface tissue_surface(const TissueVolume& tissues, const TissueSet& region, const TissueSurfaceSettings& settings);

}  // namespace bodkin::anatomy
