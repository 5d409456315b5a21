#include "fem/solid/mesh_place.h"

#include <fmt/format.h>

namespace bodkin::fem {

std::string place_of(const Vec3& point) {
  return fmt::format("({:.1f}, {:.1f}, {:.1f}) mm", point.x(), point.y(), point.z());
}

Vec3 middle_of_element(const anatomy::TetrahedralMesh& mesh, std::size_t element) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t node : mesh.elements[element]) sum += mesh.nodes[node];
  return sum / 4.0;
}

std::string place_of_element(const anatomy::TetrahedralMesh& mesh, std::size_t element) {
  return place_of(middle_of_element(mesh, element));
}

}  // namespace bodkin::fem
