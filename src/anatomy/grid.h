#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "core/geometry.h"

namespace bodkin::anatomy {

// The lattice on which an image lies in the patient, carried exactly as its file gives it: no axis is flipped or
// resampled on import. Voxel (i, j, k) has its centre at origin + direction * (spacing .* (i, j, k)), LPS mm.
struct Grid {
  std::array<int, 3> size = {0, 0, 0};  // voxels along i, j, k; i runs fastest in memory
  Vec3 spacing = Vec3::Ones();          // mm between voxel centres along i, j, k; > 0
  Mat3 direction = Mat3::Identity();    // columns: unit LPS directions of i, j, k; orthonormal
  Vec3 origin = Vec3::Zero();           // LPS mm of the centre of voxel (0, 0, 0)

  std::size_t voxel_count() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }
  // Linear position of voxel (i, j, k) in memory; the indices must be inside.
  std::size_t offset(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
  bool contains(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2];
  }
  // Continuous index -> LPS mm.
  Vec3 to_patient(const Vec3& index) const { return origin + direction * spacing.cwiseProduct(index); }
  // LPS mm -> continuous index (0 at the centre of the first voxel).
  Vec3 to_index(const Vec3& point) const { return (direction.transpose() * (point - origin)).cwiseQuotient(spacing); }
  // The axis letters of i, j, k, towards which each runs: "LPS" for an ordinary axial DICOM volume, "PIR", ...
  std::string axes() const;
};

// The same lattice to within `tolerance` mm at every corner.
bool same_lattice(const Grid& a, const Grid& b, double tolerance = 1e-3);

}  // namespace bodkin::anatomy
