#include "io/images/slice_stack.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bodkin::io {
namespace {

constexpr double drift_tolerance = 0.1;  // pixels: less shear has no visible effect
constexpr double step_tolerance = 0.02;  // of a step: positions are often written rounded to 0.01 mm
constexpr double multiple_tolerance = 0.05;
constexpr double many_gaps = 0.2;  // more wide steps than this are a change of protocol, not lost slices

std::vector<double> heights(const SliceStack& stack) {
  std::vector<double> result;
  for (const Vec3& position : stack.positions)
    result.push_back((position - stack.positions.front()).dot(stack.normal()));
  return result;
}

// In-plane drift of a slice from the first one, in pixels along i and j.
std::pair<double, double> drift(const SliceStack& stack, std::size_t slice) {
  const Vec3 moved = stack.positions[slice] - stack.positions.front();
  return {moved.dot(stack.row_direction) / stack.column_spacing,
          moved.dot(stack.column_direction) / stack.row_spacing};
}

// Steps that are whole multiples of the smallest one, few of them wide: slices are missing there.
std::vector<std::size_t> find_gaps(const std::vector<double>& steps, double smallest) {
  std::vector<std::size_t> gaps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double multiple = std::round(steps[i] / smallest);
    if (std::abs(steps[i] - multiple * smallest) > multiple_tolerance * smallest) return {};
    if (multiple > 1.0) gaps.push_back(i);
  }
  const bool few =
      gaps.size() == 1 || static_cast<double>(gaps.size()) <= many_gaps * static_cast<double>(steps.size());
  return few ? gaps : std::vector<std::size_t>{};
}

// Value of one slice at pixel (i + shift_i, j + shift_j), bilinear.
struct ShiftedSlice {
  std::span<const std::int16_t> pixels;
  int columns, rows;
  double shift_i, shift_j;
  double outside;

  double operator()(int i, int j) const {
    const double x = i + shift_i, y = j + shift_j;
    const double edge = 1e-6;  // a shift of a whole number of pixels must not lose the last row to rounding
    if (x < -edge || y < -edge || x > columns - 1 + edge || y > rows - 1 + edge) return outside;
    const int i0 = std::clamp(static_cast<int>(std::floor(x)), 0, columns - 1);
    const int j0 = std::clamp(static_cast<int>(std::floor(y)), 0, rows - 1);
    const int i1 = std::min(i0 + 1, columns - 1), j1 = std::min(j0 + 1, rows - 1);
    const double u = std::clamp(x - i0, 0.0, 1.0), v = std::clamp(y - j0, 0.0, 1.0);
    return (1.0 - v) * ((1.0 - u) * at(i0, j0) + u * at(i1, j0)) + v * ((1.0 - u) * at(i0, j1) + u * at(i1, j1));
  }
  double at(int i, int j) const {
    return pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)];
  }
};

}  // namespace

StackGeometry measure_stack(const SliceStack& stack, double thickness) {
  StackGeometry geometry;
  geometry.step = geometry.smallest_step = geometry.largest_step = thickness;
  const std::size_t slices = stack.positions.size();
  if (slices < 2) return geometry;

  const std::vector<double> height = heights(stack);
  std::vector<double> steps;
  for (std::size_t i = 1; i < slices; ++i) steps.push_back(height[i] - height[i - 1]);
  std::vector<double> sorted = steps;
  std::sort(sorted.begin(), sorted.end());
  geometry.smallest_step = sorted.front();
  geometry.largest_step = sorted.back();
  geometry.step = height.back() / static_cast<double>(slices - 1);

  for (std::size_t i = 0; i < slices; ++i) {
    const double regular = static_cast<double>(i) * geometry.step;
    geometry.uneven = geometry.uneven || std::abs(height[i] - regular) > step_tolerance * geometry.step;
    const auto [across, down] = drift(stack, i);
    geometry.sheared = geometry.sheared || std::hypot(across, down) > drift_tolerance;
  }
  if (geometry.uneven) {
    geometry.gaps = find_gaps(steps, geometry.smallest_step);
    geometry.step = geometry.gaps.empty() ? sorted[sorted.size() / 2] : geometry.smallest_step;
  }
  if (geometry.sheared) {
    const Vec3 line = stack.positions.back() - stack.positions.front();
    const double across = (line - height.back() * stack.normal()).norm();
    geometry.shear_angle = std::atan2(across, height.back()) * 180.0 / std::numbers::pi;
  }
  return geometry;
}

anatomy::Grid regular_grid(const SliceStack& stack, const StackGeometry& geometry) {
  anatomy::Grid grid;
  grid.size = {stack.columns, stack.rows, static_cast<int>(stack.positions.size())};
  grid.spacing = Vec3(stack.column_spacing, stack.row_spacing, geometry.step);
  grid.direction << stack.row_direction, stack.column_direction, stack.normal();
  grid.origin = stack.positions.front();
  return grid;
}

anatomy::Grid resampled_grid(const SliceStack& stack, const StackGeometry& geometry) {
  // The grid must hold every slice: it starts at the smallest drift and is longer by the range of drifts.
  double least_i = 0.0, most_i = 0.0, least_j = 0.0, most_j = 0.0;
  for (std::size_t slice = 0; slice < stack.positions.size(); ++slice) {
    const auto [across, down] = drift(stack, slice);
    least_i = std::min(least_i, across), most_i = std::max(most_i, across);
    least_j = std::min(least_j, down), most_j = std::max(most_j, down);
  }
  const double whole = 1e-6;  // whole-pixel drifts, up to rounding, need no further pixel
  const double start_i = std::floor(least_i + whole), start_j = std::floor(least_j + whole);
  const double steps = std::floor(heights(stack).back() / geometry.step + step_tolerance);
  const auto clamped = [](double size) { return static_cast<int>(std::min(size, 1e6)); };

  anatomy::Grid grid = regular_grid(stack, geometry);
  grid.size = {clamped(stack.columns + std::ceil(most_i - whole) - start_i),
               clamped(stack.rows + std::ceil(most_j - whole) - start_j), clamped(steps + 1.0)};
  grid.origin +=
      start_i * stack.column_spacing * stack.row_direction + start_j * stack.row_spacing * stack.column_direction;
  return grid;
}

anatomy::CtVolume resample_stack(const SliceStack& stack, const anatomy::Grid& grid,
                                 std::span<const std::int16_t> voxels, std::int16_t outside) {
  const std::size_t slices = stack.positions.size();
  const std::vector<double> height = heights(stack);
  const std::size_t slice_size = static_cast<std::size_t>(stack.columns) * static_cast<std::size_t>(stack.rows);
  const auto shifted = [&](std::size_t slice) {
    const Vec3 moved = grid.origin - stack.positions[slice];
    return ShiftedSlice{voxels.subspan(slice * slice_size, slice_size),
                        stack.columns,
                        stack.rows,
                        moved.dot(stack.row_direction) / stack.column_spacing,
                        moved.dot(stack.column_direction) / stack.row_spacing,
                        static_cast<double>(outside)};
  };

  anatomy::CtVolume result(grid, outside);
  std::size_t below = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    const double z = std::min(k * grid.spacing[2], height.back());
    while (below + 2 < slices && height[below + 1] <= z) ++below;
    const std::size_t above = std::min(below + 1, slices - 1);
    const double span = height[above] - height[below];
    double weight = span > 0.0 ? (z - height[below]) / span : 0.0;
    if (weight < step_tolerance) weight = 0.0;
    if (weight > 1.0 - step_tolerance) weight = 1.0;
    const ShiftedSlice lower = shifted(below), upper = shifted(above);
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        double value = 0.0;
        if (weight < 1.0) value += (1.0 - weight) * lower(i, j);
        if (weight > 0.0) value += weight * upper(i, j);
        result.at(i, j, k) = static_cast<std::int16_t>(std::lround(value));
      }
    }
  }
  return result;
}

}  // namespace bodkin::io
