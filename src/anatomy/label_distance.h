#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::anatomy {

// Distances between the labels of a volume, exact and in one sweep along each axis whatever the number of labels
// (lower envelopes of parabolas, Felzenszwalb and Huttenlocher 2012, restarted where the label changes). The edge of
// the volume is not a border. Voxels with a label of `left_out` are neighbours like all others, but nothing is
// computed for them.

// mm from the centre of each voxel to the nearest centre of a voxel with another label; infinite without one, and
// where the voxel is left out.
std::vector<float> distance_to_other_label(const Volume<std::uint8_t>& labels,
                                           std::span<const std::uint8_t> left_out = {});

// Which voxels lie in a ball of one label that is thick enough. A voxel c is the centre of such a ball when the
// border is at least `radius`[c] mm away (to 1e-5 mm); the border lies half a voxel (of the smallest spacing) before
// the other label's centre. The voxels not marked are those that a morphological opening by balls of these radii
// removes: sheets, threads and specks. `distance` is distance_to_other_label(labels); `radius` has as many values,
// mm. 1 = thick enough, 0 = not, or left out.
std::vector<std::uint8_t> thick_enough(const Volume<std::uint8_t>& labels, const std::vector<float>& distance,
                                       const std::vector<float>& radius, std::span<const std::uint8_t> left_out = {});

}  // namespace bodkin::anatomy
