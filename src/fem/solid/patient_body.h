#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"
#include "fem/solid/elastic_body.h"

namespace bodkin {

// A patient's mesh as a body that can be condensed, and what was assumed on the way, one sentence each.
struct PatientBody {
  BodyDescription body;
  std::vector<std::string> notes;
};

// What `settings` make of a patient's mesh. Materials are those of the tissue library, Young's modulus times
// stiffness_scale. Fixed are, as the settings say, bone and metal (tissues that are rigid in `layered`), the faces
// where the mesh ends but the patient does not (behind them lies tissue, or the edge of the volume), and what lies
// beyond a depth along the planned path. The corridor are the free nodes that are closest to the planned path. Throws
// InputError when there is no planned path, when a tissue of the mesh has no material, or when no node lies in the
// corridor.
PatientBody describe_body(TetrahedralMesh mesh, const Case& patient, const DeformableBodySettings& settings);

// The tissue that a needle meets at each node of a condensed body: that of the voxel there or, where that is air, of
// the closest one within 3 mm that is not, so that thin layers which the mesh has merged are felt. Nodes beside rigid
// tissue keep the tissue of the mesh.
void take_tissues_of_voxels(CondensedBody& body, const Case& patient);

}  // namespace bodkin
