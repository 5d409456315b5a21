#include "fem/solid/left_points.h"

#include <algorithm>

#include <fmt/format.h>

#include "anatomy/mesh_parts.h"
#include "core/error.h"
#include "fem/solid/mesh_patch.h"
#include "fem/solid/tip_compliance.h"

namespace bodkin::fem {

namespace {

constexpr double shaft_radius = 0.5;     // mm: a ball as compliant as 1 mm of a thin needle's shaft
constexpr double left_spacing = 1.0;     // mm
constexpr double longest_left = 1000.0;  // mm

}  // namespace

Mat3 shaft_gain_in(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials, std::uint32_t element) {
  const ElasticMaterial& material = *materials.find(mesh.tissues[element]);
  return shaft_gain(material, edge_of_volume(anatomy::element_volume(mesh, element)), shaft_radius);
}

std::vector<LeftPoint> left_points(const anatomy::TetrahedralMesh& mesh, const PointFinder& finder,
                                   const ElasticMaterials& materials, const anatomy::NeedlePath& needle) {
  const double length = needle.length();
  if (!(length > 0.0 && length <= longest_left)) {
    throw InputError(
        fmt::format("a needle that was left in the body is {} mm long, expected more than 0 and at most "
                    "{:.0f} mm from its entry to its tip",
                    length, longest_left));
  }
  const Vec3 direction = needle.direction();
  std::vector<LeftPoint> points;
  for (double depth = std::min(0.5 * left_spacing, 0.5 * length); depth <= length; depth += left_spacing) {
    const Vec3 place = needle.entry + depth * direction;
    const PointInMesh found = finder.find(place);
    if (found.moves()) points.push_back({place, depth, found, shaft_gain_in(mesh, materials, found.element)});
  }
  return points;
}

}  // namespace bodkin::fem
