#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fem/solid/elastic_body.h"
#include "fem/solid/points_in_mesh.h"
#include "imaging/tissue_displacement.h"

namespace bodkin::station {

// The displacement of a body's tissue everywhere, from that of the nodes of its mesh: for images in any plane.
class TissueLattice {
 public:
  // Locates the points of a lattice over the whole mesh in it, which takes some tenths of a second.
  explicit TissueLattice(const fem::BodyDescription& body);

  // `nodes`: mm, 3 for every node of the mesh. Null: no visible displacement.
  std::shared_ptr<const imaging::TissueDisplacement> moved(std::span<const float> nodes) const;

 private:
  imaging::PointLattice lattice_;
  std::vector<fem::PointInMesh> places_;
};

}  // namespace bodkin::station
