#pragma once

#include <array>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"
#include "imaging/slice.h"

namespace bodkin::imaging {

// The intersection of a plane and one tetrahedron: a triangle or a quadrangle.
struct CutElement {
  anatomy::TissueId tissue = 0;
  int corners = 0;               // 3 or 4
  std::array<Vec3, 4> points{};  // LPS mm, in order around the outline
};

// Every tetrahedron of a mesh that the (unbounded) plane cuts, in the mesh's order. A corner in the plane counts as
// behind it, so that neighbours share their outlines and nothing is drawn twice.
std::vector<CutElement> cut_mesh(const anatomy::TetrahedralMesh& mesh, const SlicePlane& plane);

}  // namespace bodkin::imaging
