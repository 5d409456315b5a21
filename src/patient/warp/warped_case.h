#pragma once

#include "patient/warp/skin_fit.h"

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

// The skin of a case. Throws InputError when it has none.
Skin skin_of(const anatomy::TissueVolume& tissues);

// The patient in the body to which it was fitted: CT (trilinear), structures and tissues (nearest voxel) on the
// patient's lattices moved with it, planned path and landmarks. Voxels from outside the patient's volumes are air.
// The description says how it was made; files and digests are empty.
anatomy::Case warped_case(const anatomy::Case& patient, const SkinFit& fit, const Progress& progress = {});

}  // namespace bodkin::patient
