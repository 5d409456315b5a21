#pragma once

#include "patient/from_ct/spinal_canal.h"

namespace bodkin::patient {

// Without labels, marrow with little bone looks like soft tissue. Every area enclosed by cortex in a sagittal section
// of the posterior elements (gaps up to 2 mm ignored, areas up to 4 cm^2) becomes cancellous bone, in the view and in
// the tissues. The canal runs through every sagittal section and so is never enclosed.
void fill_marrow(SpineView& view, anatomy::TissueVolume& tissues, const SpinalCanal& canal);

}  // namespace bodkin::patient
