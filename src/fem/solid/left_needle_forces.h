#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "anatomy/needle_path.h"
#include "fem/solid/bound_points.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/points_in_mesh.h"

namespace bodkin::fem {

// The forces by which needles left in a body hold its tissue when anything else moves it: f_c of BoundPoints, so that
// the display contains the same needles as the equations of a needle in the hand.
class LeftNeedleForces {
 public:
  // No needle.
  LeftNeedleForces() = default;
  // Needles from their entry to their tip. `body`: null if a needle meets the body's nodes, which left needles do not
  // bind. Throws InputError for a needle of zero length.
  LeftNeedleForces(const ContactBody* body, std::span<const anatomy::NeedlePath> left);

  bool empty() const noexcept { return places_.empty(); }
  // The points at which they hold the tissue.
  const std::vector<PointInMesh>& places() const noexcept { return places_; }
  // N on the tissue, 3 rows for each of places(), from the displacement that every node of the mesh would have
  // without the needles (mm, 3 rows each), column by column.
  Eigen::MatrixXd against(const Eigen::MatrixXd& moved) const;
  // As above, from the displacements of places().
  Eigen::MatrixXd against_places(Eigen::MatrixXd moved) const;

 private:
  BoundPoints bound_;
  std::vector<PointInMesh> places_;
};

// Displacement of these places, 3 rows each, from that of every node of the mesh.
Eigen::MatrixXd at_places(std::span<const PointInMesh> places, const Eigen::MatrixXd& moved);

}  // namespace bodkin::fem
