#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "imaging/tissue_displacement.h"

namespace bodkin::app {

// The displacement of the tissue of a deformable body around the path of an attempt, for slices: from the
// displacements of lattice points, which the session reports. They fade out towards the lattice's border.
class SliceTissue {
 public:
  // Begins a session. Returns the points whose displacements it must report (LPS mm, at rest): `others`, then those
  // of the lattice. A lattice point in air is replaced by the skin below it.
  std::vector<Vec3> follow(std::vector<Vec3> others, const anatomy::NeedlePath& path,
                           const anatomy::TissueVolume& tissues);
  // The displacements of `others`; all displacements if the session reports no others.
  std::span<const float> of_others(std::span<const float> displacements) const;
  // From the same displacements. Returns the previous result until the difference is large enough for new slices;
  // null: nothing has moved.
  const std::shared_ptr<const imaging::TissueDisplacement>& now(std::span<const float> displacements);

 private:
  imaging::PointLattice lattice_;
  std::size_t others_ = 0;     // points of the session that do not belong to the lattice
  std::vector<bool> borders_;  // whether each lattice point is on its border
  std::shared_ptr<const imaging::TissueDisplacement> now_;
};

}  // namespace bodkin::app
