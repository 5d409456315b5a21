#pragma once

#include <vector>

#include "anatomy/needle_path.h"
#include "core/geometry.h"
#include "fem/solid/elastic_material.h"
#include "fem/solid/points_in_mesh.h"

namespace bodkin::fem {

// A point at which a needle left in a body sticks to it.
struct LeftPoint {
  Vec3 place = Vec3::Zero();  // mm, LPS, at rest
  double depth = 0.0;         // mm below its entry, along it
  PointInMesh in_mesh;
  Mat3 gain = Mat3::Zero();  // mm/N, by which needle and tissue separate there under 1 N between them
};

// One point for each millimetre of it that is in the mesh, as for a shaft (shaft_gain). Throws InputError for a
// needle of zero length.
std::vector<LeftPoint> left_points(const anatomy::TetrahedralMesh& mesh, const PointFinder& finder,
                                   const ElasticMaterials& materials, const anatomy::NeedlePath& needle);

// mm/N, 3 x 3: the compliance that the mesh lacks at a point on a thin needle's shaft in this element.
Mat3 shaft_gain_in(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials, std::uint32_t element);

}  // namespace bodkin::fem
