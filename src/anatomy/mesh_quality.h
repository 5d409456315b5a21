#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin::anatomy {

// The six dihedral angles of a tetrahedron in degrees, in the order of the edges (0,1), (0,2), (0,3), (1,2), (1,3),
// (2,3). Regular: 70.53 each. The angle at an edge of zero length is 0.
std::array<double, 6> dihedral_angles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept;

// Elements and nodes of one tissue.
struct TissueMesh {
  TissueId tissue = 0;
  std::size_t elements = 0;
  std::size_t nodes = 0;  // of its elements; nodes on a border count for both sides
  double volume = 0.0;    // mm^3
};

inline constexpr int angle_bins = 36;  // of 5 degrees

// Measures of the quality of a mesh.
struct MeshQuality {
  std::size_t nodes = 0, elements = 0;
  std::size_t not_positive = 0;                                     // elements whose volume is zero or negative
  double volume = 0.0;                                              // mm^3
  double smallest_volume = 0.0, largest_volume = 0.0;               // mm^3, of an element
  double smallest_angle = 0.0, largest_angle = 0.0;                 // degrees, dihedral
  std::size_t below_10 = 0;                                         // elements with a dihedral angle below 10 degrees
  std::array<std::size_t, angle_bins> angles{};                     // dihedral angles from 0, 5, 10, ... degrees
  double shortest_edge = 0.0, mean_edge = 0.0, longest_edge = 0.0;  // mm
  double mean_edge_in_region = 0.0;                                 // mm, over edges whose middle is in the region
  std::size_t nodes_in_region = 0;
  std::vector<TissueMesh> tissues;  // by id
};

// Measures a mesh; corners must be nodes. `in_region` tells whether a point (LPS mm) is in the region of special
// interest, such as the corridor of the needle; empty: no point is.
MeshQuality measure_quality(const TetrahedralMesh& mesh, const std::function<bool(const Vec3&)>& in_region = {});

}  // namespace bodkin::anatomy
