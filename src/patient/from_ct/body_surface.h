#pragma once

#include <string>
#include <vector>

#include "patient/from_ct/morphology.h"

#include "anatomy/case.h"

namespace bodkin::patient {

// The patient's body, on a lattice of about 2.5 mm made of whole blocks of CT voxels.
struct BodySurface {
  anatomy::Volume<float> distance;  // mm to the surface in contact with outside air; negative inside the body
  MaskVolume lung;                  // air-filled lung inside the body
  bool has_skin = false;            // false: the image lies wholly inside the body, without outside air
  double edge = 0.0;                // mm, the longest edge of a block
  std::vector<std::string> notes;
};

// The body is the largest solid object (HU above -300, after an opening by 4.5 mm that removes sheets such as the
// couch, and bridges to the arms) with the enclosed gas and lung. Air counts as outside only if it reaches a lateral,
// front or back face of the image over a large area. Lung cut by the image border is inside: it is uneven and reaches
// no corner of the image, as air of the room does. Voxels of lung structures are always inside; `structures` lies on
// the lattice of `ct` or is empty. Throws InputError when the CT contains nothing solid.
BodySurface find_body(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                      const std::vector<anatomy::Structure>& table);

// HU of the skin surface.
inline constexpr float skin_surface_hounsfield = -300.0F;

}  // namespace bodkin::patient
