#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "anatomy/tissue.h"
#include "anatomy/volume.h"

namespace bodkin::forces {

// The tissues along a frozen insertion line, in layers of equal thickness. Layer 0 begins at the entry point; each
// layer has the tissue at its middle. Layers are looked up once, as the needle reaches them, into memory allocated at
// construction, so that extending the path in the tick costs one look-up per layer and no allocation.
class TissuePath {
 public:
  // `layer`: mm, > 0. `longest`: mm, the greatest depth that will be requested.
  TissuePath(double layer, double longest);

  // Starts a new line at `entry` along the unit vector `direction` (LPS). Forgets the old layers.
  void restart(const Vec3& entry, const Vec3& direction) noexcept;
  // Looks up the layers to the one that contains `depth` (at most `longest`). Outside the volume is air.
  void extend_to(double depth, const anatomy::TissueVolume& tissues) noexcept;

  std::span<const anatomy::TissueId> layers() const noexcept { return {layers_.data(), known_}; }
  double layer() const noexcept { return layer_; }

 private:
  double layer_;
  std::size_t known_ = 0;
  Vec3 entry_ = Vec3::Zero();
  Vec3 direction_ = Vec3::UnitZ();
  std::vector<anatomy::TissueId> layers_;
};

}  // namespace bodkin::forces
