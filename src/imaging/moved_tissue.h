#pragma once

#include <array>
#include <vector>

#include "imaging/slice.h"

namespace bodkin::imaging {

// Points on a lattice along the patient's axes.
struct PointLattice {
  Vec3 corner = Vec3::Zero();           // LPS mm, the point with the least coordinates
  double spacing = 5.0;                 // mm
  std::array<int, 3> size = {0, 0, 0};  // points along x, y and z

  // LPS mm of all, x fastest.
  std::vector<Vec3> points() const;
};

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

 private:
  PointLattice lattice_;
  std::vector<float> displacements_;
};

// What lies in a plane of a patient whose tissue has moved.
Slice cut_moved(const SlicePlane& plane, const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                const MovedTissue& moved);

}  // namespace bodkin::imaging
