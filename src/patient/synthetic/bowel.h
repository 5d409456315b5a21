#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/geometry.h"

namespace bodkin::patient {

// Loops of small bowel: ellipsoids of 25 to 35 mm at jittered places of a lattice, merging into one another.
class Bowel {
 public:
  struct Loop {
    Vec3 centre = Vec3::Zero();
    Vec3 radii = Vec3::Zero();  // 0: no loop in this cell
    bool gas = false;           // holds gas besides fluid
  };

  Bowel() = default;
  // Fills the box from `low` to `high` (mm); a loop is kept if `allowed` accepts its centre.
  Bowel(const Vec3& low, const Vec3& high, std::uint64_t seed, const std::function<bool(const Vec3&)>& allowed);

  // The loop that contains p, or nullptr; `depth` is set to the distance inside its wall.
  const Loop* at(const Vec3& p, double& depth) const;

 private:
  Vec3 low_ = Vec3::Zero();
  int size_[3] = {0, 0, 0};
  std::vector<Loop> loops_;  // size_[0] * size_[1] * size_[2], x fastest
};

}  // namespace bodkin::patient
