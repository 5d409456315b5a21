#pragma once

#include <span>

#include "scene/surfaces.h"

#include "anatomy/case.h"

namespace bodkin::scene {

// Divides the surfaces by the structures of a segmentation, so that each organ, vessel, vertebra or disc can have its
// own look: triangles are ordered by the structure of the surface's tissue just under them, and `sections` lists
// them. Triangles without a structure keep the surface's name. Skin, ligamentum flavum and dural sac are not divided.
// No effect for empty `labels`.
void find_sections(const anatomy::LabelVolume& labels, std::span<const anatomy::Structure> structures,
                   PatientSurfaces& surfaces);

}  // namespace bodkin::scene
