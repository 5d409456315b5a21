#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"
#include "io/mesh/foreign_mesh.h"

namespace bodkin::patient {

// A foreign mesh with the tissues of a case: the tissue of each region is in a label scheme (io/label_scheme.h;
// `origin` names it), or, without a scheme, the region is the id of a tissue. Elements of negative volume are
// reordered. Changes are appended to `notes`. Throws InputError for a region without a tissue, and for an element
// without volume (below 1e-9 mm^3), naming it.
anatomy::TetrahedralMesh with_tissues(const io::ForeignMesh& foreign, const anatomy::TissueLibrary& library,
                                      const std::vector<anatomy::Structure>& scheme, const std::string& origin,
                                      std::vector<std::string>& notes);

}  // namespace bodkin::patient
