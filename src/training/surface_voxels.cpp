#include "training/surface_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bodkin::training {

namespace {

constexpr double cell = 0.5;            // mm
constexpr std::size_t coarse_step = 8;  // points of a way

struct IndexBox {
  std::array<int, 3> low{}, high{};  // both within the volume
  bool empty = true;
};

// The voxels within `reach` mm of a way.
IndexBox box_around(const anatomy::Grid& grid, const std::vector<WayPoint>& way, double reach) {
  IndexBox box;
  if (way.empty()) return box;
  Vec3 least = Vec3::Constant(std::numeric_limits<double>::infinity()), most = -least;
  for (const WayPoint& each : way) {
    const Vec3 index = grid.to_index(each.tip);
    least = least.cwiseMin(index);
    most = most.cwiseMax(index);
  }
  box.empty = false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    const double voxels = reach / grid.spacing[axis] + 1.0, last = grid.size[at] - 1;
    const double low = std::max(0.0, std::floor(least[axis] - voxels));
    const double high = std::min(last, std::ceil(most[axis] + voxels));
    if (!(low <= high)) box.empty = true;
    if (box.empty) return box;
    box.low[at] = static_cast<int>(low);
    box.high[at] = static_cast<int>(high);
  }
  return box;
}

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
SurfaceVoxels<Voxel>::SurfaceVoxels(const anatomy::Volume<Voxel>& volume, const std::set<Voxel>& labels,
                                    const std::vector<WayPoint>& way)
    : grid_(volume.grid) {
  const IndexBox box = box_around(grid_, way, farthest);
  if (box.empty) return;
  std::vector<char> wanted(std::size_t{std::numeric_limits<Voxel>::max()} + 1, 0);
  for (const Voxel label : labels) wanted[label] = 1;
  for (int k = box.low[2]; k <= box.high[2]; ++k) {
    for (int j = box.low[1]; j <= box.high[1]; ++j) {
      for (int i = box.low[0]; i <= box.high[0]; ++i) {
        const Voxel label = volume.at(i, j, k);
        if (wanted[label] != 0 && is_on_surface(volume, i, j, k)) indices_[label].emplace_back(i, j, k);
      }
    }
  }
}

template <typename Voxel>
std::optional<NearestVoxel> SurfaceVoxels<Voxel>::nearest_to(Voxel label, const std::vector<WayPoint>& way) const {
  const auto place = indices_.find(label);
  if (place == indices_.end()) return std::nullopt;
  const auto distance_at = [&](std::size_t p) {
    const Vec3 index = grid_.to_index(way[p].tip);
    double here = std::numeric_limits<double>::infinity();
    for (const Vec3& voxel : place->second) {
      const Vec3 beyond = ((voxel - index).cwiseAbs().array() - 0.5).max(0.0);
      here = std::min(here, beyond.cwiseProduct(grid_.spacing).squaredNorm());
    }
    return std::sqrt(here);
  };
  NearestVoxel found{.distance = farthest, .point = way.size()};
  const auto take = [&](std::size_t p, double distance) {
    if (distance < found.distance) found = {distance, p};
  };
  // Every few points first. A point between them is nearer to the label than they are by no more than the way from
  // them, which leaves few that could be the nearest.
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
