#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "fem/solid/contact_body.h"
#include "fem/solid/left_needle_forces.h"
#include "fem/solid/points_in_mesh.h"

namespace bodkin::fem {

// The columns of display_columns(), for any node of a body that a needle may enter anywhere, a few nodes at a time on
// request: for displaying a needle whose line was not known beforehand.
class NodeColumns {
 public:
  // For these points. `left`: needles in the same body, which hold the tissue.
  NodeColumns(std::shared_ptr<const ContactBody> body, std::vector<PointInMesh> points,
              const LeftNeedleForces& left = {});

  // mm/N, 3 rows per point and 3 columns for each of these nodes of the mesh. Reads the body's factor once, so that
  // several nodes cost little more than one. Thread-safe.
  Eigen::MatrixXf of(std::span<const std::uint32_t> nodes) const;

 private:
  std::shared_ptr<const ContactBody> body_;
  std::vector<PointInMesh> points_;  // their nodes as indices into `nodes_`
  LeftNeedleForces left_;
  std::vector<PointInMesh> left_places_;  // as points_, for the left needles' points
  std::vector<std::uint32_t> nodes_;      // nodes of the mesh that carry points of either kind
  Eigen::MatrixXf by_left_;               // mm/N: the points by forces on the left needles' points
};

}  // namespace bodkin::fem
