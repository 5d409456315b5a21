#pragma once

#include "patient/from_ct/spinal_canal.h"

namespace bodkin::patient {

// Without labels, marrow poor in bone looks like soft tissue. Whatever a sagittal section of the posterior
// elements encloses within cortex (gaps up to 2 mm forgiven, areas up to 4 cm^2) becomes cancellous bone, in the view
// and in the tissues. The canal runs through every sagittal section and so is never enclosed.
void fill_marrow(SpineView& view, anatomy::TissueVolume& tissues, const SpinalCanal& canal);

}  // namespace bodkin::patient
