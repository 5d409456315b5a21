#include "io/digest.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace bodkin::io {
namespace {

// Values below a millionth of a micrometre are rounding noise: either sign becomes the same zero.
constexpr double negligible = 1e-9;

float rounded(double value) {
  return std::abs(value) < negligible ? 0.0F : static_cast<float>(value);
}

// Size, spacing, direction (column by column) and origin.
struct GridKey {
  std::array<std::int32_t, 3> size;
  std::array<float, 15> geometry;
};
static_assert(sizeof(GridKey) == 72, "the key must have no padding");

GridKey key_of(const anatomy::Grid& grid) {
  GridKey key{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    key.size[axis] = grid.size[axis];
    key.geometry[axis] = rounded(grid.spacing[i]);
    for (std::size_t row = 0; row < 3; ++row) {
      key.geometry[3 + 3 * axis + row] = rounded(grid.direction(static_cast<Eigen::Index>(row), i));
    }
    key.geometry[12 + axis] = rounded(grid.origin[i]);
  }
  return key;
}

}  // namespace

template <typename Voxel>
std::string volume_digest(const anatomy::Volume<Voxel>& volume) {
  const GridKey key = key_of(volume.grid);
  const XXH64_hash_t seed = XXH3_64bits(&key, sizeof key);
  const XXH128_hash_t hash = XXH3_128bits_withSeed(volume.voxels.data(), volume.voxels.size() * sizeof(Voxel), seed);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string bytes_digest(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

template std::string volume_digest(const anatomy::CtVolume& volume);
template std::string volume_digest(const anatomy::LabelVolume& volume);
template std::string volume_digest(const anatomy::TissueVolume& volume);

}  // namespace bodkin::io
