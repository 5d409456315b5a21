#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "anatomy/condensed_body.h"
#include "core/progress.h"
#include "fem/contact_line.h"
#include "fem/solid/bound_points.h"
#include "fem/solid/elastic_body.h"
#include "fem/solid/needle_stations.h"
#include "fem/solid/packed_factor.h"
#include "fem/solid/points_in_mesh.h"
#include "fem/solid/quadratic_edges.h"

namespace bodkin::fem {

// A body that a needle can enter anywhere and at any angle: it keeps its factor, and computes the compliance between
// the contact points of a needle's line when it is asked for one.
//
// A point of the line moves with its element, by barycentric weights; one that has to be punctured is a disk over
// which the tip pushes. The compliance between points is exact for the whole mesh (PackedFactor). To that of a point
// with itself is added what the mesh lacks: of a disk by local refinement (refinement_gain), of a point on the shaft
// by the solution for a ball (shaft_gain), so that what is felt hardly depends on where the mesh has its nodes, and
// the equations stay regular wherever the points lie. In a stiff skin (elements_of_stiff_skin) displacements are
// quadratic, so that it bends.
class ContactBody {
 public:
  // `body`: it must have passed check_body, but its corridor is not read. Throws InputError when the body does not
  // fit into memory, or cannot be solved; see ElasticBody.
  ContactBody(std::shared_ptr<const BodyDescription> body, const FactorOptions& options = {},
              const Progress& progress = {});
  // With the factor of this body from elsewhere. Throws InputError when it has another number of unknowns.
  ContactBody(std::shared_ptr<const BodyDescription> body, PackedFactor factor);

  const BodyDescription& description() const noexcept { return *body_; }
  const PackedFactor& factor() const noexcept { return *factor_; }
  // On which displacements are quadratic.
  const QuadraticEdges& edges() const noexcept { return edges_; }

  // What needles that were left in the body, from their entry to their tip, and nodes of its mesh that are held do to
  // it; a node that is fixed anyway does nothing. Of a needle each millimetre that is in the mesh is a point, as of a
  // shaft. Throws InputError for a needle without length, and for a node that is not in the mesh or named twice.
  BoundPoints bind(std::span<const anatomy::NeedlePath> left, std::span<const std::uint32_t> held) const;

  // The contact points at these stations of a line along the unit vector `direction`: one node for each, in their
  // order. Left out are stations farther than 5 mm from the mesh, and the third and further ones without a border in
  // one element. `tip_radius`: mm, above 0. Any number of threads may ask at once; the same bits for any number of
  // `threads`, which share the work (0: as many as the machine has cores). `bound`: of this body, with what it does.
  // Throws InputError when no station is left.
  anatomy::CondensedBody contact_points(std::span<const NeedleStation> stations, const Vec3& direction,
                                        double tip_radius, int threads = 0, const BoundPoints& bound = {}) const;

  // mm/N: how these nodes of the mesh move by unit forces on each of `points`, 3 rows a node and 3 columns a point.
  Eigen::MatrixXd displacements(std::span<const CarriedPoint> points, std::span<const std::uint32_t> nodes) const;

  // A place of the mesh as a point that its nodes carry, by barycentric weights in a stiff skin too; those that are
  // held carry nothing.
  CarriedPoint carried(const PointInMesh& place) const;

 private:
  friend class LinePoints;
  static constexpr std::size_t points_at_once = 8;  // that share reading the factor

  std::shared_ptr<const BodyDescription> body_;
  std::vector<bool> fixed_;                // by node of the mesh
  std::vector<bool> stiff_skin_;           // by element of the mesh
  QuadraticEdges edges_;                   // of the stiff skin
  std::vector<std::uint32_t> free_nodes_;  // by node of the mesh, as the equations number it
  std::shared_ptr<const PackedFactor> factor_;
  PointFinder finder_;
};

}  // namespace bodkin::fem
