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

}  // namespace bodkin::fem
