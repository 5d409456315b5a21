#pragma once

#include "patient/warp/skin_fit.h"

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

// The skin of a case. Throws InputError when it has none.
Skin skin_of(const anatomy::TissueVolume& tissues);

// The patient as it lies in the body that it was fitted to: CT (trilinear), structures and tissues (nearest voxel) on
// the patient's lattices moved with it, planned path and landmarks. What a border voxel would have to bring from
// outside the patient's volumes is air. A description that says how it was made; files and digests are empty.
anatomy::Case warped_case(const anatomy::Case& patient, const SkinFit& fit, const Progress& progress = {});

}  // namespace bodkin::patient
