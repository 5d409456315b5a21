#include "patient/synthetic/bowel.h"

#include "patient/synthetic/shapes.h"

#include "core/random.h"

namespace bodkin::patient {
namespace {

constexpr double kCell = 25.0;  // mm

}  // namespace

Bowel::Bowel(const Vec3& low, const Vec3& high, std::uint64_t seed, const std::function<bool(const Vec3&)>& allowed)
    : low_(low) {
  for (int axis = 0; axis < 3; ++axis)
    size_[axis] = std::max(static_cast<int>(std::ceil((high[axis] - low[axis]) / kCell)), 1);
  for (int k = 0; k < size_[2]; ++k) {
    for (int j = 0; j < size_[1]; ++j) {
      for (int i = 0; i < size_[0]; ++i) {
        const auto cell = static_cast<std::int64_t>(loops_.size());
        const Vec3 jitter(hash_noise(seed ^ 1u, cell), hash_noise(seed ^ 2u, cell), hash_noise(seed ^ 3u, cell));
        Loop loop;
        loop.centre = low + kCell * (Vec3(i, j, k) + Vec3::Constant(0.5) + 0.26 * jitter);
        if (allowed(loop.centre)) {
          loop.radii = Vec3(14.5, 13.0, 14.5) + 2.5 * Vec3(jitter.y(), jitter.z(), jitter.x());
          loop.gas = jitter.x() + jitter.y() > 0.9;
        }
        loops_.push_back(loop);
      }
    }
  }
}

const Bowel::Loop* Bowel::at(const Vec3& p, double& depth) const {
  const Vec3 place = (p - low_) / kCell;
  const int x = static_cast<int>(std::floor(place.x())), y = static_cast<int>(std::floor(place.y())),
            z = static_cast<int>(std::floor(place.z()));
  for (int k = std::max(z - 1, 0); k <= std::min(z + 1, size_[2] - 1); ++k) {
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size_[1] - 1); ++j) {
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size_[0] - 1); ++i) {
        const int cell = (k * size_[1] + j) * size_[0] + i;
        const Loop& loop = loops_[static_cast<std::size_t>(cell)];
        const double largest = loop.radii.maxCoeff();
        if (largest <= 0.0 || (p - loop.centre).squaredNorm() > largest * largest) continue;
        const double distance = shapes::ellipsoid(p - loop.centre, loop.radii);
        if (distance > 0.0) continue;
        depth = -distance;
        return &loop;
      }
    }
  }
  return nullptr;
}

}  // namespace bodkin::patient
