#pragma once

#include "patient/synthetic/lumbar.h"
#include "patient/synthetic/sizes.h"

namespace bodkin::patient {

// Hounsfield units for a volume of tissues: the library's value of each tissue, blurred by the scanner's point spread
// (Gaussian, standard deviation 0.7 mm), plus a smooth texture and noise that is white in space, of the tissue's
// standard deviation. A voxel's noise depends only on the seed and its position. Throws InputError when the library
// lacks a tissue.
anatomy::CtVolume paint_ct(const anatomy::TissueVolume& tissues, const anatomy::TissueLibrary& library,
                           const LumbarSizes& sizes, std::uint64_t seed, const Progress& progress);

}  // namespace bodkin::patient
