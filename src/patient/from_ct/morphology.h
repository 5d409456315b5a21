#pragma once

#include <cstdint>

#include "anatomy/volume.h"

namespace bodkin::patient {

using MaskVolume = anatomy::Volume<std::uint8_t>;  // 0 or 1

// Distance in mm from each voxel centre to the surface of the mask: negative inside, positive outside. The border of
// the image is not a surface. The mask must contain both 0 and 1 (else every value is far beyond the image's size).
anatomy::Volume<float> signed_distance(const MaskVolume& mask);

// The largest piece of the mask connected through voxel faces; empty if the mask is.
MaskVolume largest_piece(const MaskVolume& mask);

// Numbers the pieces connected through voxel faces 1, 2, ..., the largest first; 0 outside the mask.
anatomy::Volume<std::uint32_t> number_pieces(const MaskVolume& mask);

}  // namespace bodkin::patient
