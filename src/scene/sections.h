#pragma once

#include <span>

#include "scene/surfaces.h"

#include "anatomy/case.h"

namespace bodkin::scene {

// Divides the surfaces by the structures of a segmentation, so that each organ, vessel, vertebra or disc can have a
// look of its own: triangles are ordered by the structure of the surface's tissue that lies just under them, and
// `sections` says which are whose. Triangles of no structure keep the surface's own name. Skin, ligamentum flavum and
// dural sac stay whole. Nothing happens where `labels` is empty.
void find_sections(const anatomy::LabelVolume& labels, std::span<const anatomy::Structure> structures,
                   PatientSurfaces& surfaces);

}  // namespace bodkin::scene
