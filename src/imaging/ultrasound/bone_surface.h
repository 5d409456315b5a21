#pragma once

#include "imaging/ultrasound/acoustic_volume.h"

namespace bodkin::imaging {

// Labels give the surface of bone steps, which would all appear in the image. Voxels at the border of bone get an
// impedance between that of bone and that of the surrounding tissue, by the local fraction of bone (voxels weighted 1
// : 2 : 1 along each axis, contrast of the fraction doubled): surfaces along the lattice are not changed, and steps
// of others are smoothed. Tissue ids do not change, and gas is excluded. Axes whose voxels are more than 1.5 times as
// long as the shortest are left out.
void smooth_bone_surface(AcousticVolume& volume);

}  // namespace bodkin::imaging
