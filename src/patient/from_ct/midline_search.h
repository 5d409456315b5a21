#pragma once

#include <functional>
#include <optional>

#include "patient/from_ct/body_surface.h"
#include "patient/from_ct/spine_view.h"

namespace bodkin::patient {

// The position of a lumbar spine in a CT without spine labels.
struct SpineMidline {
  PatientBox box;                      // about the spine, skin to vertebral bodies
  std::function<double(double)> x_at;  // LPS x of the midline at LPS z
};

// Searches for the sagittal plane with the most bone behind a canal-like gap, that of the spinous processes. Slices
// that contain lung are not lumbar and are skipped. Empty when less than 30 mm of laminae are found.
std::optional<SpineMidline> find_midline(const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                                         const BodySurface& body);

}  // namespace bodkin::patient
