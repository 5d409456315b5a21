#pragma once

#include <optional>
#include <string>
#include <vector>

#include "patient/meshing/mesh_plan.h"

#include "anatomy/case.h"
#include "anatomy/tetrahedral_mesh.h"
#include "core/progress.h"

// Meshes are made by a program of its own (bodkin-mesher), because the library that does it, CGAL's Mesh_3, is under
// the GPL, and because it takes much memory for a moment. Labels go there and the mesh comes back through memory that
// the two share.

namespace bodkin::patient {

struct MeshedBody {
  anatomy::TetrahedralMesh mesh;   // one part that hangs together, every element positive
  double scale = 1.0;              // its edges are about this times those of the settings
  std::vector<std::string> notes;  // what was merged, cut off or missed, one sentence each
};

// Meshes the tissues of a case near its planned path (all of them without a path), with about the wanted number
// of nodes: the edges are scaled, at most six times, until the number lies within 10 %; what is then missed is
// noted. `library` gives the names for notes. The same input gives the same mesh. Throws InputError when nothing can
// be meshed, the number of nodes cannot be reached or is too small for the layers that are to be held (the sentence
// names the smallest number that is not), SystemError when bodkin-mesher is missing or fails.
MeshedBody mesh_tissues(const anatomy::TissueVolume& tissues, const std::optional<anatomy::NeedlePath>& path,
                        const anatomy::TissueLibrary& library, const MeshSettings& settings,
                        const Progress& progress = {});

// Whether bodkin-mesher is there.
bool mesher_present();

}  // namespace bodkin::patient
