#pragma once

#include <span>
#include <vector>

#include "imaging/slice.h"

namespace bodkin::imaging {

// The coarse grid of points over a plane, `spacing` mm apart or slightly closer, from which a slice of a deformed
// patient is warped: as a plane whose pixels are the points, row after row.
SlicePlane warp_grid(const SlicePlane& plane, double spacing);

// LPS mm of all pixels of a plane, row after row: the points whose displacement a warp requires.
std::vector<Vec3> points_of(const SlicePlane& plane);

// The content of a plane when the patient is deformed: at each pixel the CT and tissue of the position X at rest that
// has moved there, X + u(X) = pixel, found by iteration. `displacements`: mm, x y z of each point of `grid`, linear
// between them; u is taken as constant across the plane, which holds for slices through the needle. In tissue
// compressed to less than half its thickness the result is the iteration's best.
Slice cut_deformed(const SlicePlane& plane, const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                   const SlicePlane& grid, std::span<const float> displacements);

// The inverse field, for images that need the tissue at a place now: at each point of `grid` the displacement of the
// tissue that is there now, mm, x y z of each point. Found as in cut_deformed.
std::vector<float> displacements_of_places(const SlicePlane& grid, std::span<const float> displacements);

}  // namespace bodkin::imaging
