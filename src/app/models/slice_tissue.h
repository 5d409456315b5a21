#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "imaging/moved_tissue.h"

namespace bodkin::app {

// How the tissue about the path of an attempt has moved, for slices, of a body that deforms: from the displacements
// of the points of a lattice, which the session is asked for. Towards the lattice's border they fade out.
class SliceTissue {
 public:
  // A session begins. Returns the points whose displacements it is asked for (LPS mm, at rest): `others`, then those
  // of the lattice. Of one that lies in the air it is the skin below.
  std::vector<Vec3> follow(std::vector<Vec3> others, const anatomy::NeedlePath& path,
                           const anatomy::TissueVolume& tissues);
  // Of the displacements of those points: those of `others`; all of them where the session was not asked.
  std::span<const float> of_others(std::span<const float> displacements) const;
  // Of the same displacements. The one before, as long as none differs from it by as much as is worth other slices;
  // null: nothing has moved.
  const std::shared_ptr<const imaging::MovedTissue>& now(std::span<const float> displacements);

 private:
  imaging::PointLattice lattice_;
  std::size_t others_ = 0;     // points of the session that are not of the lattice
  std::vector<bool> borders_;  // of the lattice's points: it lies at its border
  std::shared_ptr<const imaging::MovedTissue> now_;
};

}  // namespace bodkin::app
