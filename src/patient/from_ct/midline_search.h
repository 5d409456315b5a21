#pragma once

#include <functional>
#include <optional>

#include "patient/from_ct/body_surface.h"
#include "patient/from_ct/spine_view.h"

namespace bodkin::patient {

// Where a lumbar spine lies in a CT without spine labels.
struct SpineMidline {
  PatientBox box;                      // about the spine, skin to vertebral bodies
  std::function<double(double)> x_at;  // LPS x of the midline at LPS z
};

// Looks for the sagittal plane in which the most bone stands behind a canal-like gap: that is where the spinous
// processes are. Slices with lung in them are not lumbar and are passed over. Nothing when no 30 mm of laminae are
// found.
std::optional<SpineMidline> find_midline(const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                                         const BodySurface& body);

}  // namespace bodkin::patient
