#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/geometry.h"

namespace bodkin::anatomy {

// A surface made of triangles, LPS mm. The corners of a triangle run counterclockwise seen from outside, so the
// normal (b - a) x (c - a) points out of the body. The surface may be open, and may have several pieces.
class Surface {
 public:
  Surface() = default;
  // Stores vertices and triangles; a triangle whose least height is below 1e-8 mm has no normal and is left out.
  // Throws InputError for a vertex that is not finite or farther than 1e4 mm from the origin, for a corner that is
  // not a vertex, and where two triangles run along an edge in the same direction: their orientations disagree, or
  // more than two triangles share the edge.
  Surface(std::vector<Vec3> vertices, std::vector<std::array<int, 3>> triangles);

  const std::vector<Vec3>& vertices() const { return vertices_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
  // neighbours()[t][e]: triangle on the other side of the edge from corner e to corner e + 1; -1 at a border.
  const std::vector<std::array<int, 3>>& neighbours() const { return neighbours_; }
  // Number of triangles left out because they have no normal.
  std::size_t left_out() const { return left_out_; }

  bool empty() const { return triangles_.empty(); }
  // Whether the surface has no border, so that its inside is well defined.
  bool closed() const;
  // Unit outward normal of triangle t.
  Vec3 normal(std::size_t t) const;

 private:
  void find_neighbours();

  std::vector<Vec3> vertices_;
  std::vector<std::array<int, 3>> triangles_;   // corners
  std::vector<std::array<int, 3>> neighbours_;  // triangles_.size()
  std::size_t left_out_ = 0;
};

}  // namespace bodkin::anatomy
