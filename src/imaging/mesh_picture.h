#pragma once

#include <optional>
#include <string>

#include "anatomy/case.h"
#include "anatomy/mesh_quality.h"
#include "anatomy/tetrahedral_mesh.h"
#include "imaging/canvas.h"

namespace bodkin::imaging {

// An image of a mesh: the whole mesh and the surroundings of the path, both cut by the plane along the path (the
// sagittal one through the middle without a path), each cut element with its outline and the colour of its tissue;
// and the distribution of its dihedral angles. The mesh must not be empty.
Canvas mesh_picture(const anatomy::TetrahedralMesh& mesh, const anatomy::MeshQuality& quality,
                    const std::optional<anatomy::NeedlePath>& path, const anatomy::TissueLibrary& library,
                    const std::string& title);

}  // namespace bodkin::imaging
