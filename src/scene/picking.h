#pragma once

#include <optional>

#include "scene/camera.h"
#include "scene/mesh.h"

namespace bodkin::scene {

// The intersection of a ray and a surface.
struct SurfacePoint {
  Vec3 point = Vec3::Zero();    // LPS mm
  Vec3 normal = Vec3::UnitZ();  // unit, outwards, interpolated between the points of the triangle
  std::size_t triangle = 0;
  Vec3 weights = Vec3::Zero();  // of its corners; their sum is 1
};

// The first point at which the ray enters the surface; triangles seen from behind are ignored. 18000 triangles take
// 0.1 ms.
std::optional<SurfacePoint> first_hit(const SceneMesh& mesh, const ViewRay& ray);

}  // namespace bodkin::scene
