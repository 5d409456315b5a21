#pragma once

#include <array>
#include <span>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin::study {

// A plane layer of a stack.
struct MeshLayer {
  anatomy::TissueId tissue = anatomy::tissue::air;
  double thickness = 0.0;  // mm, above 0
};

// A stack of plane layers as tetrahedra: a block `width` (mm) wide whose surface is z = 0, depth along +z, divided
// into bricks of six tetrahedra. Nodes lie on every border of layers, on the line x = y = 0 and at most `edge` (mm)
// apart along each axis. All lengths above 0. Throws InputError when the nodes would exceed 400,000.
anatomy::TetrahedralMesh mesh_of_layers(std::span<const MeshLayer> layers, double width, double edge);

}  // namespace bodkin::study
