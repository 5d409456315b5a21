#include "fem/moving/deformable_body_solver.h"

namespace bodkin::fem {

DeformableBodySolver::DeformableBodySolver(const BodyDescription& body, const BodySolverSettings& settings)
    : moving_(body, settings.motion), press_(body.mesh, body.fixed, settings.probe) {}

const CorotationalStep& DeformableBodySolver::step(const std::optional<Pose>& probe) noexcept {
  if (probe) {
    press_.press(*probe, moving_);
  } else {
    press_.lift(moving_);
  }
  const CorotationalStep& step = moving_.step();
  press_.let_go_what_is_pulled(moving_);
  return step;
}

void read_displacements(const CorotationalBody& body, std::span<float> displacements) noexcept {
  for (std::uint32_t node = 0; node < body.nodes(); ++node) {
    const Vec3 moved = body.position(node) - body.at_rest(node);
    for (std::size_t i = 0; i < 3; ++i)
      displacements[3 * node + i] = static_cast<float>(moved[static_cast<Eigen::Index>(i)]);
  }
}

}  // namespace bodkin::fem
