#pragma once

#include <string>
#include <vector>

#include "patient/from_ct/body_surface.h"
#include "patient/from_ct/tissue_lattice.h"

#include "anatomy/case.h"

namespace bodkin::patient {

// Specks of bone smaller than this are noise or calcification, mL.
inline constexpr double smallest_bone = 0.05;

// Removes from the bone in `tissues` dense pieces that are not bone, by position and connectivity: unlabelled pieces
// that are not connected to the skeleton (even through corners), and that the image border does not cut.
//   speck            less than smallest_bone and more than 8 mm from other bone: soft tissue
//   stone or         deeper than 45 mm below the skin, less than 5 mL and more than 8 mm from other bone: soft tissue
//   calcification
//   enhanced vessel  deeper than 45 mm, at least 5 mL and of uniform HU (a standard deviation below a fifth of a mean
//                    of at most 600 HU): a vessel; the image border may cut it, as it cuts the aorta
// In an image without skin depth is unknown, and only specks are removed. Returns one sentence for each kind that was
// found. The sizes are our choice. [D]
std::vector<std::string> remove_dense_pieces(anatomy::TissueVolume& tissues, const anatomy::CtVolume& ct,
                                             const anatomy::LabelVolume& structures, const TissueLattice& lattice,
                                             const BodySurface& body);

}  // namespace bodkin::patient
