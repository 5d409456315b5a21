#include "training/surface_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace bodkin::training {

namespace {

constexpr double cell = 0.5;            // mm
constexpr std::size_t coarse_step = 8;  // points of a way
constexpr int block_side = 8;           // voxels

template <typename Voxel>
bool is_on_surface(const anatomy::Volume<Voxel>& volume, int i, int j, int k) {
  const Voxel own = volume.at(i, j, k);
  const auto& size = volume.grid.size;
  const auto differs = [&](int x, int y, int z) {
    return x < 0 || y < 0 || z < 0 || x >= size[0] || y >= size[1] || z >= size[2] || volume.at(x, y, z) != own;
  };
  return differs(i - 1, j, k) || differs(i + 1, j, k) || differs(i, j - 1, k) || differs(i, j + 1, k) ||
         differs(i, j, k - 1) || differs(i, j, k + 1);
}

}  // namespace

std::vector<WayPoint> way_in_body(const Attempt& attempt) {
  std::vector<WayPoint> way;
  std::set<std::array<long, 3>> visited;
  std::array<long, 3> before{};
  for (std::size_t i = 0; i < attempt.size(); ++i) {
    if (attempt.inside[i] == 0) continue;
    const Vec3& tip = attempt.tip[i];
    const std::array<long, 3> here = {std::lround(tip.x() / cell), std::lround(tip.y() / cell),
                                      std::lround(tip.z() / cell)};
    if (!way.empty() && here == before) continue;
    before = here;
    if (visited.insert(here).second) way.push_back({tip, i});
  }
  return way;
}

template <typename Voxel>
SurfaceVoxels<Voxel>::SurfaceVoxels(const anatomy::Volume<Voxel>& volume, const std::set<Voxel>& labels)
    : grid_(volume.grid) {
  std::vector<char> wanted(std::size_t{std::numeric_limits<Voxel>::max()} + 1, 0);
  for (const Voxel label : labels) wanted[label] = 1;
  std::map<std::pair<Voxel, std::array<int, 3>>, std::vector<Index>> cells;
  for (int k = 0; k < grid_.size[2]; ++k) {
    for (int j = 0; j < grid_.size[1]; ++j) {
      const Voxel* const row = &volume.voxels[grid_.offset(0, j, k)];
      for (int i = 0; i < grid_.size[0]; ++i) {
        const Voxel label = row[i];
        if (wanted[label] == 0 || !is_on_surface(volume, i, j, k)) continue;
        cells[{label, {i / block_side, j / block_side, k / block_side}}].push_back(
            {static_cast<std::int16_t>(i), static_cast<std::int16_t>(j), static_cast<std::int16_t>(k)});
      }
    }
  }
  for (auto& [place, voxels] : cells) {
    Block block{voxels.front(), voxels.front(), {}};
    for (const Index& voxel : voxels) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        block.low[axis] = std::min(block.low[axis], voxel[axis]);
        block.high[axis] = std::max(block.high[axis], voxel[axis]);
      }
    }
    block.voxels = std::move(voxels);
    blocks_[place.first].push_back(std::move(block));
  }
}

template <typename Voxel>
double SurfaceVoxels<Voxel>::distance_to(const std::vector<Block>& blocks, const Vec3& index) const {
  // mm^2, squared distance to the box from the voxel `low` to the voxel `high`.
  const auto square_to = [&](const Index& low, const Index& high) {
    double square = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = index[static_cast<Eigen::Index>(axis)];
      const double beyond = std::max({0.0, low[axis] - 0.5 - x, x - high[axis] - 0.5});
      square += beyond * beyond * grid_.spacing[static_cast<Eigen::Index>(axis)] *
                grid_.spacing[static_cast<Eigen::Index>(axis)];
    }
    return square;
  };
  const auto nearest_block = std::min_element(blocks.begin(), blocks.end(), [&](const Block& a, const Block& b) {
    return square_to(a.low, a.high) < square_to(b.low, b.high);
  });
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Block& block) {
    for (const Index& voxel : block.voxels) least = std::min(least, square_to(voxel, voxel));
  };
  look_at(*nearest_block);
  for (const Block& block : blocks)
    if (square_to(block.low, block.high) < least) look_at(block);
  return std::sqrt(least);
}

template <typename Voxel>
std::optional<NearestVoxel> SurfaceVoxels<Voxel>::nearest_to(Voxel label, const std::vector<WayPoint>& way) const {
  const auto place = blocks_.find(label);
  if (place == blocks_.end()) return std::nullopt;
  const auto distance_at = [&](std::size_t p) { return distance_to(place->second, grid_.to_index(way[p].tip)); };
  NearestVoxel found{.distance = farthest, .point = way.size()};
  const auto take = [&](std::size_t p, double distance) {
    if (distance < found.distance) found = {distance, p};
  };
  // Every few points first. A point between them is nearer to the label by at most its distance from them, which
  // leaves few candidates.
  std::vector<double> known;
  for (std::size_t p = 0; p < way.size(); p += coarse_step) {
    known.push_back(distance_at(p));
    take(p, known.back());
  }
  for (std::size_t p = 0; p < way.size(); ++p) {
    const std::size_t before = p / coarse_step, at = before * coarse_step;
    if (p == at) continue;
    const auto least_here = [&](std::size_t which) {
      return known[which] - (way[p].tip - way[which * coarse_step].tip).norm();
    };
    if (least_here(before) >= found.distance) continue;
    if (before + 1 < known.size() && least_here(before + 1) >= found.distance) continue;
    take(p, distance_at(p));
  }
  return found.point < way.size() ? std::optional(found) : std::nullopt;
}

template class SurfaceVoxels<std::uint16_t>;
template class SurfaceVoxels<std::uint8_t>;

}  // namespace bodkin::training
