#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::fem {

// The body that `settings` make of a patient's mesh, without a corridor. Materials are those of the tissue library,
// Young's modulus times stiffness_scale. Fixed nodes, depending on the settings, are those of bone and metal (tissues
// that are rigid in `layered`), of the faces where the mesh ends but the patient does not (with tissue or the edge of
// the volume behind them), and beyond a depth along the planned path (`path` if the case has none). Throws InputError
// when a tissue of the mesh has no material, and when `path` has zero length.
BodyDescription describe_body(anatomy::TetrahedralMesh mesh, const anatomy::Case& patient,
                              const anatomy::DeformableBodySettings& settings, const anatomy::NeedlePath& path);

// The nodes of a body that form the corridor about a path: the closest free ones, in ascending order. A note, one
// sentence, is added when they exceed the limit. Throws InputError when no node lies near the path.
std::vector<std::uint32_t> corridor_about(const BodyDescription& body, const anatomy::NeedlePath& path,
                                          const anatomy::CorridorSettings& settings, std::vector<std::string>& notes);

// Sets the tissue of each node of a condensed body to that of the voxel there or, if that is air, of the closest one
// within 3 mm that is not, so that thin layers which the mesh has merged are felt. Nodes next to rigid tissue keep
// the tissue of the mesh.
void take_tissues_of_voxels(anatomy::CondensedBody& body, const anatomy::Case& patient);

}  // namespace bodkin::fem
