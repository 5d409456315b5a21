#pragma once

#include "imaging/ultrasound/acoustic_volume.h"

namespace bodkin::imaging {

// Labels make stairs of a bone's surface, and sound would show every step of them. Voxels at the border of bone get
// an impedance between that of the bone and that of the tissue about them, by the share that bone has there (voxels
// weighted 1 : 2 : 1 along each axis, the share made twice as decided): surfaces along the lattice stay as they are,
// and steps of the others are filled and worn. Tissue ids stay, and gas has no share in it. Axes whose voxels are
// more than 1.5 times as long as the shortest are left out.
void smooth_bone_surface(AcousticVolume& volume);

}  // namespace bodkin::imaging
