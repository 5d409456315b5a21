#pragma once

#include "patient/from_ct/body_surface.h"
#include "patient/from_ct/tissue_lattice.h"

#include "anatomy/case.h"

namespace bodkin::patient {

// Reclassifies enhanced vessels that touch bone, and are therefore connected to it, from bone to vessel. On the
// blocks of `body`, about 2.5 mm, it looks for cores: blocks deeper than 45 mm below the skin, full of unlabelled
// voxels as dense as bone, with such blocks at all six faces, and joined only to blocks of nearly the same mean HU. A
// core counts as a vessel when
//   its mean is 600 HU at most and its standard deviation below 12 % of that,
//   it is at least 2.5 times as long as thick, and contains 2 mL, and
//   it has no shell, as bone has: less than a tenth of the dense voxels around it is brighter than 1.25 times its
//   mean.
// The vessel is the core with the two blocks around it, except voxels brighter than 1.25 times its mean. Where it
// lies on bone, up to a block of bone is included. The sizes are our choice. [D] Returns the volume in mL; 0 in an
// image without skin, where depth is unknown.
double take_out_contrast_on_bone(anatomy::TissueVolume& tissues, const anatomy::CtVolume& ct,
                                 const anatomy::LabelVolume& structures, const TissueLattice& lattice,
                                 const BodySurface& body);

}  // namespace bodkin::patient
