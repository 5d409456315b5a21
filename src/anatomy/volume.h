#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "anatomy/grid.h"

namespace bodkin::anatomy {

// An image on a grid: voxels in file order, i fastest.
template <typename Voxel>
struct Volume {
  Grid grid;
  std::vector<Voxel> voxels;  // grid.voxel_count() values

  Volume() = default;
  explicit Volume(const Grid& lattice, Voxel value = Voxel{}) : grid(lattice), voxels(lattice.voxel_count(), value) {}

  Voxel& at(int i, int j, int k) { return voxels[grid.offset(i, j, k)]; }
  const Voxel& at(int i, int j, int k) const { return voxels[grid.offset(i, j, k)]; }
  bool empty() const { return voxels.empty(); }
};

using CtVolume = Volume<std::int16_t>;      // HU
using LabelVolume = Volume<std::uint16_t>;  // structure labels, as a segmentation numbers them
using TissueVolume = Volume<std::uint8_t>;  // tissue ids of the tissue library

// HU; the lowest value of the CT scale as scanners store it.
inline constexpr std::int16_t lowest_hounsfield = -1024;

// The voxel whose cell contains `index` (continuous), or `outside` beyond the outermost cells. Never throws.
template <typename Voxel>
Voxel nearest_at_index(const Volume<Voxel>& volume, const Vec3& index, Voxel outside) noexcept {
  const Vec3 rounded = (index.array() + 0.5).floor();
  const bool inside = rounded.x() >= 0.0 && rounded.y() >= 0.0 && rounded.z() >= 0.0 &&
                      rounded.x() < volume.grid.size[0] && rounded.y() < volume.grid.size[1] &&
                      rounded.z() < volume.grid.size[2];
  if (!inside) return outside;  // also for NaN, for which every comparison is false
  return volume.at(static_cast<int>(rounded.x()), static_cast<int>(rounded.y()), static_cast<int>(rounded.z()));
}

// The voxel whose cell contains `point` (LPS mm), or `outside`.
template <typename Voxel>
Voxel nearest(const Volume<Voxel>& volume, const Vec3& point, Voxel outside) noexcept {
  return nearest_at_index(volume, volume.grid.to_index(point), outside);
}

// Trilinear value at continuous `index`; points up to half a voxel outside the outermost centres take the border
// value, points further out give `outside`.
template <typename Voxel>
double linear_at_index(const Volume<Voxel>& volume, const Vec3& index, double outside) noexcept {
  const auto& size = volume.grid.size;
  int base[3];
  double weight[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double last = size[static_cast<std::size_t>(axis)] - 1;
    const double x = index[axis];
    if (!(x >= -0.5 && x <= last + 0.5)) return outside;
    const double clamped = x < 0.0 ? 0.0 : (x > last ? last : x);
    base[axis] = static_cast<int>(clamped);
    if (base[axis] > 0 && base[axis] >= static_cast<int>(last)) base[axis] = static_cast<int>(last) - 1;
    weight[axis] = clamped - base[axis];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const int di = corner & 1, dj = (corner >> 1) & 1, dk = (corner >> 2) & 1;
    const double w = (di != 0 ? weight[0] : 1.0 - weight[0]) * (dj != 0 ? weight[1] : 1.0 - weight[1]) *
                     (dk != 0 ? weight[2] : 1.0 - weight[2]);
    // A weight of zero may belong to a neighbour that does not exist (an axis one voxel thick).
    if (w != 0.0) sum += w * static_cast<double>(volume.at(base[0] + di, base[1] + dj, base[2] + dk));
  }
  return sum;
}

// Trilinear value at `point` (LPS mm), see linear_at_index.
template <typename Voxel>
double linear(const Volume<Voxel>& volume, const Vec3& point, double outside) noexcept {
  return linear_at_index(volume, volume.grid.to_index(point), outside);
}

}  // namespace bodkin::anatomy
