#pragma once

#include "scene/mesh.h"

#include "anatomy/tissue_surface.h"
#include "anatomy/volume.h"

namespace bodkin::scene {

// Fills mesh.openness: how much of the sky over each point is not hidden by tissues of `occluders` within 17 mm,
// which makes hollows dark (ambient occlusion). 40 directions spread evenly over the hemisphere about the normal,
// weighted by their cosine; what hides at a distance t counts 1 - t / 17 mm. `cell`: mm, of the lattice that the mesh
// was drawn on.
void find_openness(const anatomy::TissueVolume& tissues, const anatomy::TissueSet& occluders, double cell,
                   SceneMesh& mesh);

}  // namespace bodkin::scene
