#include "imaging/warped_slice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "imaging/rest_place.h"

namespace bodkin::imaging {

namespace {

// Displacement at a place, by its projection onto the grid; beyond the grid that of its border.
Vec3 displacement_at(const Vec3& place, const SlicePlane& grid, std::span<const float> displacements) {
  const Eigen::Vector2d at = grid.place(place);
  const double column = std::clamp(at.x(), 0.0, grid.width - 1.0), row = std::clamp(at.y(), 0.0, grid.height - 1.0);
  const int left = std::min(static_cast<int>(column), std::max(grid.width - 2, 0));
  const int top = std::min(static_cast<int>(row), std::max(grid.height - 2, 0));
  const double right_share = column - left, low_share = row - top;
  Vec3 sum = Vec3::Zero();
  for (int down = 0; down < 2; ++down) {
    for (int right = 0; right < 2; ++right) {
      const double share = (right == 1 ? right_share : 1.0 - right_share) * (down == 1 ? low_share : 1.0 - low_share);
      if (share == 0.0) continue;
      const auto point = 3 * (static_cast<std::size_t>(top + down) * static_cast<std::size_t>(grid.width) +
                              static_cast<std::size_t>(left + right));
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum[static_cast<Eigen::Index>(axis)] += share * static_cast<double>(displacements[point + axis]);
    }
  }
  return sum;
}

}  // namespace

SlicePlane warp_grid(const SlicePlane& plane, double spacing) {
  SlicePlane grid = plane;
  const double across = plane.pixel * std::max(plane.width - 1, 1),
               down = plane.pixel * std::max(plane.height - 1, 1);
  const double cells = std::max(1.0, std::ceil(across / spacing));
  grid.pixel = across / cells;
  grid.width = static_cast<int>(cells) + 1;
  grid.height = static_cast<int>(std::ceil(down / grid.pixel)) + 1;
  return grid;
}

std::vector<Vec3> points_of(const SlicePlane& plane) {
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height));
  for (int row = 0; row < plane.height; ++row)
    for (int column = 0; column < plane.width; ++column) points.push_back(plane.point(column, row));
  return points;
}

Slice cut_deformed(const SlicePlane& plane, const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                   const SlicePlane& grid, std::span<const float> displacements) {
  Slice slice;
  slice.plane = plane;
  const auto displacement = [&](const Vec3& at) { return displacement_at(at, grid, displacements); };
  for (const Vec3& pixel : points_of(plane)) {
    const Vec3 rest = rest_place(pixel, displacement);
    slice.hounsfield.push_back(
        static_cast<float>(anatomy::linear(ct, rest, std::numeric_limits<double>::quiet_NaN())));
    slice.tissues.push_back(anatomy::nearest(tissues, rest, Slice::outside));
  }
  return slice;
}

std::vector<float> displacements_of_places(const SlicePlane& grid, std::span<const float> displacements) {
  std::vector<float> moved;
  moved.reserve(displacements.size());
  const auto displacement = [&](const Vec3& at) { return displacement_at(at, grid, displacements); };
  for (const Vec3& place : points_of(grid)) {
    const Vec3 here = place - rest_place(place, displacement);
    for (Eigen::Index axis = 0; axis < 3; ++axis) moved.push_back(static_cast<float>(here[axis]));
  }
  return moved;
}

}  // namespace bodkin::imaging
