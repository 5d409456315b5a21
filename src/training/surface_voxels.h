#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "anatomy/volume.h"
#include "training/attempt.h"

namespace bodkin::training {

// The path of the tip in the body, thinned: the first of the ticks in each cell of 0.5 mm.
struct WayPoint {
  Vec3 tip = Vec3::Zero();  // LPS mm
  std::size_t tick = 0;     // index
};
std::vector<WayPoint> way_in_body(const Attempt& attempt);

struct NearestVoxel {
  double distance = 0.0;  // mm to the voxel's box
  std::size_t point = 0;  // of the path, index
};

// The voxels of some labels that border on another label: to a point outside a label no other voxel of it is nearer
// than these. They lie in blocks, of which distant ones are skipped.
template <typename Voxel>
class SurfaceVoxels {
 public:
  static constexpr double farthest = 100.0;  // mm from the path; voxels farther away count as absent

  SurfaceVoxels(const anatomy::Volume<Voxel>& volume, const std::set<Voxel>& labels);

  // The nearest pair of a path point and a voxel of the label; empty if none is within `farthest`.
  std::optional<NearestVoxel> nearest_to(Voxel label, const std::vector<WayPoint>& way) const;

 private:
  using Index = std::array<std::int16_t, 3>;
  struct Block {
    Index low{}, high{};  // the box around its voxels
    std::vector<Index> voxels;
  };

  // mm from a continuous index to the box of the nearest voxel.
  double distance_to(const std::vector<Block>& blocks, const Vec3& index) const;

  anatomy::Grid grid_;
  std::map<Voxel, std::vector<Block>> blocks_;
};

extern template class SurfaceVoxels<std::uint16_t>;
extern template class SurfaceVoxels<std::uint8_t>;

// Of a patient: data for scoring many attempts, computed once.
struct PatientSurfaces {
  SurfaceVoxels<std::uint16_t> structures;
  SurfaceVoxels<std::uint8_t> tissues;
};

}  // namespace bodkin::training
