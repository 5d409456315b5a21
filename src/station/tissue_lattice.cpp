#include "station/tissue_lattice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "station/slice_field.h"

namespace bodkin::station {

namespace {

constexpr double spacing = 4.0;      // mm; an edge of a mesh is about twice as long
constexpr int most_points = 60'000;  // a step of the lattice takes one millisecond
constexpr double around = 8.0;       // mm of air over the skin that move with it
constexpr float seen = 0.05F;        // mm

imaging::PatientBox box_around(const anatomy::TetrahedralMesh& mesh) {
  imaging::PatientBox box{mesh.nodes.front(), mesh.nodes.front()};
  for (const Vec3& node : mesh.nodes) {
    box.low = box.low.cwiseMin(node);
    box.high = box.high.cwiseMax(node);
  }
  box.low.array() -= around;
  box.high.array() += around;
  return box;
}

}  // namespace

TissueLattice::TissueLattice(const fem::BodyDescription& body)
    : lattice_(imaging::lattice_around(box_around(body.mesh), spacing, most_points)),
      places_(fem::find_points(body.mesh, lattice_.points(), std::sqrt(3.0) * (around + lattice_.spacing))) {}

std::shared_ptr<const imaging::TissueDisplacement> TissueLattice::moved(std::span<const float> nodes) const {
  if (std::none_of(nodes.begin(), nodes.end(), [](float part) { return std::abs(part) > seen; })) return nullptr;
  std::vector<float> displacements;
  move_points(places_, nodes, displacements);
  return std::make_shared<const imaging::TissueDisplacement>(lattice_, std::move(displacements));
}

}  // namespace bodkin::station
