#include "fem/moving/deformable_body_solver.h"

namespace bodkin::fem {

DeformableBodySolver::DeformableBodySolver(const BodyDescription& body, const BodySolverSettings& settings)
    : moving_(body, settings.motion, settings.left_needles), press_(body.mesh, body.fixed, settings.probe) {}

const CorotationalStep& DeformableBodySolver::step(const std::optional<Pose>& probe) noexcept {
  if (probe) {
    press_.press(*probe, moving_);
  } else {
    press_.lift(moving_);
  }
  const CorotationalStep& step = moving_.step();
  press_.release_pulled_nodes(moving_);
  return step;
}

BodyField field_at_rest(const DeformableBodySolver& solver) {
  BodyField field;
  field.moved.assign(3 * solver.body().nodes(), 0.0F);
  field.held.assign(solver.press().surface().size(), 0);
  return field;
}

void read_field(const DeformableBodySolver& solver, bool failed, BodyField& field) noexcept {
  ++field.step;
  if (failed) {
    field.moved.clear();
    field.held_count = 0;
    return;
  }
  const CorotationalBody& body = solver.body();
  for (std::uint32_t node = 0; node < body.nodes(); ++node) {
    const Vec3 moved = body.position(node) - body.at_rest(node);
    for (std::size_t i = 0; i < 3; ++i)
      field.moved[3 * node + i] = static_cast<float>(moved[static_cast<Eigen::Index>(i)]);
  }
  if (solver.press().holds(field.held_nodes())) return;
  solver.press().held_nodes(field.held);
  field.held_count = solver.press().held();
  field.held_since = field.step;
}

}  // namespace bodkin::fem
