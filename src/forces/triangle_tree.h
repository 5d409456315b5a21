#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "anatomy/surface.h"
#include "core/geometry.h"

namespace bodkin::forces {

// The point where a segment first enters a surface.
struct SurfaceHit {
  double part = 0.0;           // of the segment, 0 to 1
  Vec3 normal = Vec3::Zero();  // unit, outwards
  std::int32_t triangle = -1;  // of the surface; -1: no entry
};

// The triangles of a surface in a tree of boxes, to find where a moving point enters.
class TriangleTree {
 public:
  // The cost is n log n. The tree keeps a copy of the triangles.
  explicit TriangleTree(const anatomy::Surface& surface);

  // Where the segment from `start` along `ray` (mm) first passes through a triangle from outside to inside; passages
  // outwards do not count. A start up to 1e-9 mm behind a triangle still counts as before it, and triangles reach
  // 1e-7 mm beyond their edges (more at grazing incidence), so that rounding opens no seam between neighbours. If
  // several triangles are met at one place, the one with the lowest number is returned. Never throws; nothing for a
  // segment that is not finite.
  SurfaceHit first_entry(const Vec3& start, const Vec3& ray) const noexcept;

 private:
  struct Box {
    std::array<float, 3> low, high;  // x, y, z, mm; rounded outwards
    std::uint32_t first;             // leaf: its first triangle; else: its right child, the left one is the next box
    std::uint32_t count;             // leaf: number of triangles; else 0
  };
  struct Side {
    Vec3 normal;                       // unit, outwards
    double level;                      // normal . x of the plane
    std::array<Vec3, 3> edge;          // unit, in the plane, away from the triangle
    std::array<double, 3> edge_level;  // edge . x of the edges
    std::int32_t triangle;             // of the surface
  };

  void split(std::vector<std::uint32_t>& order, const std::vector<Box>& bounds, std::uint32_t first,
             std::uint32_t last);
  void meet(const Side& side, const Vec3& start, const Vec3& ray, SurfaceHit& best) const noexcept;

  std::vector<Box> boxes_;   // depth first; [0] holds all
  std::vector<Side> sides_;  // in the order of the leaves
};

}  // namespace bodkin::forces
