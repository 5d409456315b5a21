#include "fem/solid/left_needle_forces.h"

#include <cstddef>
#include <utility>

#include "fem/solid/left_points.h"

namespace bodkin::fem {

LeftNeedleForces::LeftNeedleForces(const ContactBody* body, std::span<const anatomy::NeedlePath> left) {
  if (body == nullptr || left.empty()) return;
  bound_ = body->bind(left, {});
  const BodyDescription& description = body->description();
  const PointFinder finder(description.mesh);
  for (const anatomy::NeedlePath& needle : left)
    for (const LeftPoint& point : left_points(description.mesh, finder, description.materials, needle))
      places_.push_back(point.in_mesh);
}

Eigen::MatrixXd LeftNeedleForces::against(const Eigen::MatrixXd& moved) const {
  return against_places(at_places(places_, moved));
}

Eigen::MatrixXd LeftNeedleForces::against_places(Eigen::MatrixXd moved) const {
  return bound_.forces_against(std::move(moved));
}

Eigen::MatrixXd at_places(std::span<const PointInMesh> places, const Eigen::MatrixXd& moved) {
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(places.size()), moved.cols());
  for (std::size_t p = 0; p < places.size(); ++p)
    for (std::size_t corner = 0; corner < 4; ++corner)
      found.middleRows<3>(3 * static_cast<Eigen::Index>(p)) +=
          places[p].weights[corner] * moved.middleRows<3>(3 * Eigen::Index{places[p].nodes[corner]});
  return found;
}

}  // namespace bodkin::fem
