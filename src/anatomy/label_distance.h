#pragma once

#include <cstdint>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::anatomy {

// Distances between the labels of a volume, exact and in one sweep along each axis whatever the number of labels
// (lower envelopes of parabolas, Felzenszwalb and Huttenlocher 2012, restarted where the label changes). Beyond the
// outermost voxels there is nothing: the edge of the volume is no border.

// mm from the centre of each voxel to the nearest centre of a voxel with another label; infinite where there is
// none.
std::vector<float> distance_to_other_label(const Volume<std::uint8_t>& labels);

// Which voxels lie in a ball of one label that is thick enough: a voxel c is the middle of one when its border is at
// least `radius`[c] mm away (to 1e-5 mm), the border lying half a voxel (of the smallest spacing) before the other
// label's centre.
// What is left out is what a morphological opening by balls of these radii takes away: sheets, threads and specks.
// `distance` is distance_to_other_label(labels); `radius` has as many values, mm. 1 = thick enough, 0 = not.
std::vector<std::uint8_t> thick_enough(const Volume<std::uint8_t>& labels, const std::vector<float>& distance,
                                       const std::vector<float>& radius);

}  // namespace bodkin::anatomy
