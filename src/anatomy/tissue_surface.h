#pragma once

#include <bitset>

#include "anatomy/surface.h"
#include "anatomy/tissue.h"
#include "anatomy/volume.h"

namespace bodkin::anatomy {

// A set of tissues.
using TissueSet = std::bitset<256>;

// Everything but the air around the patient: its surface is the skin.
TissueSet body_tissues();
// Cortical and cancellous bone: its surface is what a needle meets.
TissueSet bone_tissues();

// How fine a surface is drawn. [D] our choice; the defaults are for skin, take 1 and 1 mm for bone.
struct TissueSurfaceSettings {
  double edge = 2.0;       // mm, wished edge of the cells of the lattice that it is drawn on; 0.2 to 20 [D]
  double smoothing = 2.0;  // mm, standard deviation of the Gaussian that takes the steps off; 0 to 10 [D]
};

// The surface of the voxels made of `region`, LPS mm, closed: a region that the image cuts off gets a flat lid there.
//
// The share of `region` is averaged over whole blocks of voxels of about `edge`, smoothed, and drawn where it is one
// half, with one vertex per mixed cell at the mean of the crossings of the cell's edges (surface nets; Gibson 1998).
// Places where the region touches itself in an edge or a corner only are filled first, so that every edge has two
// triangles and every vertex one fan. A sheet thinner than about 1.35 times the smoothing is lost, and a surface of
// radius R moves inwards by about smoothing^2 / R. Throws InputError for settings out of
// range, for an empty volume, and when nothing of `region` is left.
Surface tissue_surface(const TissueVolume& tissues, const TissueSet& region, const TissueSurfaceSettings& settings);

}  // namespace bodkin::anatomy
