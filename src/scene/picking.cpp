#include "scene/picking.h"

#include <limits>

namespace bodkin::scene {

std::optional<SurfacePoint> first_hit(const SceneMesh& mesh, const ViewRay& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<SurfacePoint> hit;
  const auto at = [&](std::int32_t corner) { return static_cast<std::size_t>(corner); };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    const Vec3 a = mesh.points[at(corners[0])].cast<double>();
    const Vec3 ab = mesh.points[at(corners[1])].cast<double>() - a;
    const Vec3 ac = mesh.points[at(corners[2])].cast<double>() - a;
    // Moeller and Trumbore 1997: the weights of b and c, and the distance, by Cramer's rule.
    const Vec3 p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant <= 0.0) continue;  // from behind, or along the triangle
    const Vec3 from_a = ray.origin - a;
    const double b = from_a.dot(p) / determinant;
    if (b < 0.0 || b > 1.0) continue;
    const Vec3 q = from_a.cross(ab);
    const double c = ray.direction.dot(q) / determinant;
    if (c < 0.0 || b + c > 1.0) continue;
    const double distance = ac.dot(q) / determinant;
    if (distance <= 0.0 || distance >= nearest) continue;
    nearest = distance;
    hit = SurfacePoint{ray.origin + distance * ray.direction, Vec3::Zero(), t, Vec3(1.0 - b - c, b, c)};
  }
  if (hit) {
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    const auto& corners = mesh.triangles[hit->triangle];
    for (std::size_t c = 0; c < 3; ++c) {
      normal += static_cast<float>(hit->weights[static_cast<Eigen::Index>(c)]) * mesh.normals[at(corners[c])];
    }
    hit->normal = normal.cast<double>().normalized();
  }
  return hit;
}

}  // namespace bodkin::scene
