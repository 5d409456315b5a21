#pragma once

#include <string>
#include <vector>

#include "patient/from_ct/body_surface.h"
#include "patient/from_ct/tissue_lattice.h"

#include "anatomy/case.h"

namespace bodkin::patient {

// Specks of bone smaller than this are noise or calcification, mL.
inline constexpr double smallest_bone = 0.05;

// Takes out of the bone in `tissues` what is as dense as bone and is none, by place and connectivity: pieces that do
// not hang together with the skeleton (through corners, too), whose voxels no label names, and that the image border
// does not cut.
//   speck               less than smallest_bone and more than 8 mm from other bone: soft tissue
//   stone, calcification   deeper than 45 mm below the skin, less than 5 mL, more than 8 mm from other bone: soft
//   tissue enhanced vessel     deeper than 45 mm, 5 mL and more, and of even HU (a standard deviation below a fifth
//   of a
//                       mean of 600 HU at most): a vessel; the image border may cut it, for the aorta runs through
// In an image without skin depth is unknown, and only specks are taken. Returns one sentence for each kind that was
// found. The sizes are our choice. [D]
std::vector<std::string> take_out_dense_pieces(anatomy::TissueVolume& tissues, const anatomy::CtVolume& ct,
                                               const anatomy::LabelVolume& structures, const TissueLattice& lattice,
                                               const BodySurface& body);

}  // namespace bodkin::patient
