#pragma once

#include <span>
#include <vector>

#include "imaging/slice.h"

namespace bodkin::imaging {

// The coarse grid of points over a plane, `spacing` mm apart or somewhat closer, from which a slice of a deformed
// patient is warped: as a plane whose pixels are the points, row after row.
SlicePlane warp_grid(const SlicePlane& plane, double spacing);

// LPS mm of all pixels of a plane, row after row: the points whose displacement a warp needs.
std::vector<Vec3> points_of(const SlicePlane& plane);

// What lies in a plane when the patient is deformed: at each pixel the CT and tissue of the place X at rest that has
// moved there, X + u(X) = pixel, found by iteration. `displacements`: mm, x y z of each point of `grid` in turn,
// linear between them; u is taken to be the same before and behind the plane as in it, which holds for slices through
// the needle. Where tissue is crushed to less than half its thickness the iteration gives the best it has.
Slice cut_deformed(const SlicePlane& plane, const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                   const SlicePlane& grid, std::span<const float> displacements);

// The inverse field, for pictures that ask which tissue is at a place now: at each point of `grid` how the tissue
// that now is there has moved, mm, x y z of each point in turn. Found as cut_deformed finds it.
std::vector<float> displacements_of_places(const SlicePlane& grid, std::span<const float> displacements);

}  // namespace bodkin::imaging
