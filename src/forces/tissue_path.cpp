#include "forces/tissue_path.h"

#include <algorithm>
#include <cmath>

namespace bodkin::forces {

TissuePath::TissuePath(double layer, double longest)
    : layer_(layer), layers_(static_cast<std::size_t>(std::ceil(longest / layer)) + 1, anatomy::tissue::air) {}

void TissuePath::restart(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  direction_ = direction;
  known_ = 0;
}

void TissuePath::extend_to(double depth, const anatomy::TissueVolume& tissues) noexcept {
  if (!(depth >= 0.0)) return;
  const double last = std::min(std::floor(depth / layer_), static_cast<double>(layers_.size() - 1));
  const auto wanted = static_cast<std::size_t>(last) + 1;
  for (; known_ < wanted; ++known_) {
    const double middle = (static_cast<double>(known_) + 0.5) * layer_;
    layers_[known_] =
        anatomy::nearest<anatomy::TissueId>(tissues, entry_ + middle * direction_, anatomy::tissue::air);
  }
}

}  // namespace bodkin::forces
