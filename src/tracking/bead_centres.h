#pragma once

#include <vector>

#include "anatomy/volume.h"
#include "core/geometry.h"

namespace bodkin::tracking {

// A bright ball found in a CT.
struct Bead {
  Vec3 centre = Vec3::Zero();  // LPS mm
  double radius = 0.0;         // mm, of a ball of the same volume
};

// Criteria for a bead.
struct BeadSearch {
  double threshold = 300.0;                      // HU; voxels are weighted by their excess over it
  double least_radius = 0.8, most_radius = 4.0;  // mm
};

// The centres of the beads of a CT, by the weighted centroid of each connected bright part that is as large as a bead
// and equally long and wide, which excludes bone. From the largest to the smallest.
std::vector<Bead> find_beads(const anatomy::CtVolume& ct, const BeadSearch& search = {});

}  // namespace bodkin::tracking
