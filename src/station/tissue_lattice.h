#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fem/solid/elastic_body.h"
#include "fem/solid/points_in_mesh.h"
#include "imaging/moved_tissue.h"

namespace bodkin::station {

// How the tissue of a body has moved everywhere, from how the nodes of its mesh have: for pictures in any plane.
class TissueLattice {
 public:
  // Finds the points of a lattice over the whole mesh in it, which takes some tenths of a second.
  explicit TissueLattice(const fem::BodyDescription& body);

  // `nodes`: mm, 3 of every node of the mesh. Null: no tissue has moved by as much as can be seen.
  std::shared_ptr<const imaging::MovedTissue> moved(std::span<const float> nodes) const;

 private:
  imaging::PointLattice lattice_;
  std::vector<fem::PointInMesh> places_;
};

}  // namespace bodkin::station
