#pragma once

#include <vector>

#include "imaging/rest_offsets.h"
#include "imaging/slice.h"

namespace bodkin::imaging {

// The lattice around a box, `spacing` mm apart or as much more as it takes for no more than `most` points.
PointLattice lattice_around(const PatientBox& box, double spacing, int most);

// How the tissue of a deformed patient has moved, anywhere: linear between the points of a lattice at rest, and
// beyond it as at its border.
class MovedTissue {
 public:
  // `displacements`: mm, x y z of each point in turn; at least two points along each axis.
  MovedTissue(const PointLattice& lattice, std::vector<float> displacements);

  // mm, of what lies at `rest` (LPS mm) when nothing moves it.
  Vec3 of(const Vec3& rest) const;
  // LPS mm, where what now is at `place` lies when nothing moves it. Where tissue is crushed to less than half its
  // thickness it is the best that iteration gives.
  Vec3 at_rest(const Vec3& place) const;
  // The same at every point of its lattice.
  RestOffsets rest_offsets() const;
  // Moved as both say, on this one's lattice.
  MovedTissue plus(const MovedTissue& other) const;
  // mm, by which a point of the lattice has moved otherwise than in `other` at most; of another lattice: infinite.
  double most_difference(const MovedTissue& other) const;

 private:
  PointLattice lattice_;
  std::vector<float> displacements_;
};

// What lies in a plane of a patient whose tissue has moved.
Slice cut_moved(const SlicePlane& plane, const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                const MovedTissue& moved);

}  // namespace bodkin::imaging
