#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "anatomy/volume.h"
#include "training/attempt.h"

namespace bodkin::training {

// The tip in the body, thinned: at the first of the ticks in each cell of 0.5 mm.
struct WayPoint {
  Vec3 tip = Vec3::Zero();  // LPS mm
  std::size_t tick = 0;     // index
};
std::vector<WayPoint> way_in_body(const Attempt& attempt);

struct NearestVoxel {
  double distance = 0.0;  // mm to the voxel's box
  std::size_t point = 0;  // of the way, index
};

// The voxels of some labels that border on another label, near a way: nothing of a label is nearer to a point outside
// it than these are.
template <typename Voxel>
class SurfaceVoxels {
 public:
  static constexpr double farthest = 100.0;  // mm from the way; what is farther away counts as absent

  SurfaceVoxels(const anatomy::Volume<Voxel>& volume, const std::set<Voxel>& labels,
                const std::vector<WayPoint>& way);

  // Of the way and a label's voxels, the pair that is nearest; nothing where none is within `farthest`.
  std::optional<NearestVoxel> nearest_to(Voxel label, const std::vector<WayPoint>& way) const;

 private:
  anatomy::Grid grid_;
  std::map<Voxel, std::vector<Vec3>> indices_;
};

extern template class SurfaceVoxels<std::uint16_t>;
extern template class SurfaceVoxels<std::uint8_t>;

}  // namespace bodkin::training
