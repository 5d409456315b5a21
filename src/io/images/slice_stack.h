#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/volume.h"

// A stack of parallel slices from a scanner. A regular stack is a Grid; a sheared one (gantry tilt) or one with
// uneven steps is not, and is resampled onto one.

namespace bodkin::io {

// The common properties of a stack's slices, and their positions.
struct SliceStack {
  int columns = 0, rows = 0;
  double column_spacing = 1.0, row_spacing = 1.0;  // mm along i (between columns) and j (between rows)
  Vec3 row_direction = Vec3::UnitX();              // unit, LPS, along i
  Vec3 column_direction = Vec3::UnitY();           // unit, LPS, along j; orthogonal to row_direction
  std::vector<Vec3> positions;  // LPS mm of each slice's first pixel, in ascending order along normal()

  Vec3 normal() const { return row_direction.cross(column_direction); }
};

// The irregularities of a stack.
struct StackGeometry {
  double step = 1.0;              // mm along the normal: mean of a regular stack, median of an uneven one
  double smallest_step = 1.0;     // mm
  double largest_step = 1.0;      // mm
  double shear_angle = 0.0;       // degrees between the line of positions and the normal; 0 if not sheared
  bool sheared = false;           // positions drift across the slice by more than a tenth of a pixel
  bool uneven = false;            // a slice is off its regular position by more than 2 % of the step
  std::vector<std::size_t> gaps;  // slices are missing after these (0-based); uneven is then true
  bool regular() const { return !sheared && !uneven; }
};

// Measures a stack of at least one slice. `thickness` (mm) is the step of a stack that has only one.
StackGeometry measure_stack(const SliceStack& stack, double thickness);

// The lattice of a regular stack.
anatomy::Grid regular_grid(const SliceStack& stack, const StackGeometry& geometry);

// The lattice onto which an irregular stack is resampled: the stack's in-plane spacing and step, large enough to
// contain every slice. Sizes are clamped to a million, so that absurd positions can be detected.
anatomy::Grid resampled_grid(const SliceStack& stack, const StackGeometry& geometry);

// Resamples the slices of a stack (voxels slice by slice) onto its resampled_grid: bilinear within a slice, linear
// between slices; a slice already at a position of the grid is only shifted. `outside` fills the rest.
anatomy::CtVolume resample_stack(const SliceStack& stack, const anatomy::Grid& grid,
                                 std::span<const std::int16_t> voxels, std::int16_t outside);

}  // namespace bodkin::io
