#pragma once

#include <string>
#include <vector>

#include "patient/from_ct/morphology.h"

#include "anatomy/case.h"

namespace bodkin::patient {

// Where the patient's body is, on a lattice of about 2.5 mm made of whole blocks of CT voxels.
struct BodySurface {
  anatomy::Volume<float> distance;  // mm to the surface that meets outside air; negative inside the body
  MaskVolume lung;                  // air-filled lung inside the body
  bool has_skin = false;            // false: the image lies wholly inside the body, nothing meets outside air
  double edge = 0.0;                // mm, the longest edge of a block
  std::vector<std::string> notes;
};

// The body is the largest solid thing (HU above -300, after an opening by 4.5 mm that cuts off sheets such as the
// couch, and bridges to the arms) with the gas and lung that it encloses. Air counts as outside only where it reaches
// a lateral, front or back face of the image broadly. Lung that the image border cuts open is inside: it is uneven
// and reaches no corner of the image, as air of the room does. Voxels of structures made of lung are inside whatever
// reaches them; `structures` lies on the lattice of `ct` or is empty. Throws InputError when nothing in the CT is
// solid.
BodySurface find_body(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                      const std::vector<anatomy::Structure>& table);

// HU at which the surface of the skin is drawn.
inline constexpr float skin_surface_hounsfield = -300.0F;

}  // namespace bodkin::patient
