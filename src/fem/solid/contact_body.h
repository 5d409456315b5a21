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
#include "fem/solid/contact_sites.h"
#include "fem/solid/elastic_body.h"
#include "fem/solid/packed_factor.h"
#include "fem/solid/points_in_mesh.h"
#include "fem/solid/quadratic_edges.h"

namespace bodkin::fem {

// A body that a needle can enter anywhere and at any angle: it keeps its factor, and computes the compliance between
// the contact points of a needle's line on request.
//
// A point of the line moves with its element, by barycentric weights; a point at a border to be punctured is a disk
// over which the tip pushes. The compliance between points is exact for the whole mesh (PackedFactor). To the
// compliance of a point with itself is added what the mesh lacks: for a disk by local refinement (refinement_gain),
// for a point on the shaft by the solution for a ball (shaft_gain), so that the force hardly depends on the positions
// of the mesh's nodes, and the equations stay regular wherever the points lie. In a stiff skin
// (elements_of_stiff_skin) displacements are quadratic, so that it can bend.
class ContactBody {
 public:
  // `body` must have passed check_body; its corridor is not read. Throws InputError when the body does not fit into
  // memory or cannot be solved; see ElasticBody.
  ContactBody(std::shared_ptr<const BodyDescription> body, const FactorOptions& options = {},
              const Progress& progress = {});
  // With the factor of this body from elsewhere. Throws InputError if its number of unknowns differs.
  ContactBody(std::shared_ptr<const BodyDescription> body, PackedFactor factor);

  const BodyDescription& description() const noexcept { return *body_; }
  const PackedFactor& factor() const noexcept { return *factor_; }
  // The edges on which displacements are quadratic.
  const QuadraticEdges& edges() const noexcept { return edges_; }

  // The binding effect of needles left in the body, from their entry to their tip, and of held nodes of its mesh;
  // fixed nodes have no effect. Each millimetre of a needle in the mesh is a point, as for a shaft. Throws InputError
  // for a needle of zero length, and for a node that is not in the mesh or given twice.
  BoundPoints bind(std::span<const anatomy::NeedlePath> left, std::span<const std::uint32_t> held) const;

  // The contact points at these sites of a line along the unit vector `direction`: one node for each, in their
  // order. Left out are sites farther than 5 mm from the mesh, and the third and later ones without a border in
  // one element. `tip_radius`: mm, above 0. Thread-safe; the same bits for any number of `threads`, which share the
  // work (0: one per core). `bound`: bound points of this body, whose effect is included. Throws InputError when no
  // site is left.
  anatomy::CondensedBody contact_points(std::span<const ContactSite> sites, const Vec3& direction, double tip_radius,
                                        int threads = 0, const BoundPoints& bound = {}) const;

  // mm/N: displacements of these nodes of the mesh by unit forces on each of `points`, 3 rows per node and 3 columns
  // per point.
  Eigen::MatrixXd displacements(std::span<const CarriedPoint> points, std::span<const std::uint32_t> nodes) const;

  // A point of the mesh as carried by its nodes, by barycentric weights even in a stiff skin; held nodes carry
  // nothing.
  CarriedPoint carried(const PointInMesh& place) const;

 private:
  friend class LinePoints;
  static constexpr std::size_t points_at_once = 8;  // that share one pass through the factor

  std::shared_ptr<const BodyDescription> body_;
  std::vector<bool> fixed_;                // by node of the mesh
  std::vector<bool> stiff_skin_;           // by element of the mesh
  QuadraticEdges edges_;                   // of the stiff skin
  std::vector<std::uint32_t> free_nodes_;  // by node of the mesh: its number in the equations
  std::shared_ptr<const PackedFactor> factor_;
  PointFinder finder_;
};

}  // namespace bodkin::fem
