#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace bodkin::scene {

// Triangles for display, LPS mm, in single precision: all arrays of points have one length. The corners of a triangle
// run counterclockwise seen from outside.
struct SceneMesh {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals;  // of points, unit, outwards
  std::vector<float> openness;           // of points: 1 where nothing is near, 0 in the deepest corner
  std::vector<std::array<std::int32_t, 3>> triangles;

  bool empty() const { return triangles.empty(); }
};

}  // namespace bodkin::scene
