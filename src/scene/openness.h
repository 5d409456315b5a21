#pragma once

#include "scene/mesh.h"

#include "anatomy/tissue_surface.h"
#include "anatomy/volume.h"

namespace bodkin::scene {

// Computes mesh.openness: the visible fraction of the sky over each point, not hidden by tissues of `occluders`
// within 17 mm, which makes hollows dark (ambient occlusion). 40 directions spread evenly over the hemisphere about
// the normal, weighted by their cosine; an occluder at a distance t counts 1 - t / 17 mm. `cell`: mm, of the lattice
// from which the mesh was drawn.
void find_openness(const anatomy::TissueVolume& tissues, const anatomy::TissueSet& occluders, double cell,
                   SceneMesh& mesh);

}  // namespace bodkin::scene
