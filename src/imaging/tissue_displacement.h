#pragma once

#include <vector>

#include "imaging/rest_offsets.h"
#include "imaging/slice.h"

namespace bodkin::imaging {

// The lattice around a box, `spacing` mm apart or as much more as is needed for at most `most` points.
PointLattice lattice_around(const PatientBox& box, double spacing, int most);

// The displacement of a deformed patient's tissue, anywhere: linear between the points of a lattice at rest, and
// constant beyond its border.
class TissueDisplacement {
 public:
  // `displacements`: mm, x y z of each point; at least two points along each axis.
  TissueDisplacement(const PointLattice& lattice, std::vector<float> displacements);

  // mm, displacement of the point `rest` (LPS mm at rest).
  Vec3 of(const Vec3& rest) const;
  // LPS mm, position at rest of the point that is now at `place`. In tissue compressed to less than half its
  // thickness it is the best result of the iteration.
  Vec3 at_rest(const Vec3& place) const;
  // As at_rest(), at every point of the lattice.
  RestOffsets rest_offsets() const;
  // The sum of both displacements, on this object's lattice.
  TissueDisplacement plus(const TissueDisplacement& other) const;
  // mm, largest difference from `other` at a point of the lattice; for another lattice: infinite.
  double most_difference(const TissueDisplacement& other) const;

 private:
  PointLattice lattice_;
  std::vector<float> displacements_;
};

// The slice in a plane of a patient with moved tissue.
Slice cut_moved(const SlicePlane& plane, const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                const TissueDisplacement& moved);

}  // namespace bodkin::imaging
