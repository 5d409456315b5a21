#include "fem/moving/pressed_body.h"

#include <algorithm>
#include <new>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/multifrontal_cholesky.h"

namespace bodkin {

namespace {

const PressedBodySettings& checked_pressed_settings(const PressedBodySettings& settings) {
  if (!(settings.settled > 0.0 && settings.worth > 0.0)) {
    throw InputError(
        fmt::format("moving body: settled is {} mm and worth {} mm, expected both above 0; 0.05 and 0.5 are usual",
                    settings.settled, settings.worth));
  }
  return settings;
}

}  // namespace

PressedBody::PressedBody(const BodyDescription& body, const PressedBodySettings& settings)
    : settings_(checked_pressed_settings(settings)),
      description_(body),
      moving_(description_, settings.motion),
      press_(description_.mesh, description_.fixed, settings.probe),
      plan_(plan_body(description_)),
      last_corridor_(moving_.places()) {}

const CorotationalStep& PressedBody::step(const std::optional<Pose>& probe, const NodeForces& needle) noexcept {
  if (probe) {
    press_.press(*probe, moving_);
  } else {
    press_.lift(moving_);
  }
  moving_.clear_loads();
  for (std::size_t i = 0; i < std::min(needle.count, NodeForces::capacity); ++i) {
    const NodeForce& on = needle.nodes[i];
    if (on.node >= plan_.corridor.mesh_nodes.size()) continue;
    moving_.load(plan_.corridor.mesh_nodes[on.node], Vec3(on.force[0], on.force[1], on.force[2]));
  }
  const CorotationalStep& told = moving_.step();
  press_.let_go_what_is_pulled(moving_);
  settled_ = !told.fault && told.largest_move <= settings_.settled;
  judge(needle);
  return told;
}

void PressedBody::judge(const NodeForces& needle) noexcept {
  due_ = false;
  if (!settled_ || needle.count > 0) return;
  const double worth = settings_.worth * settings_.worth;
  for (Eigen::Index node = 0; node < last_corridor_.cols() && !due_; ++node)
    due_ = (moving_.places().col(node) - last_corridor_.col(node)).squaredNorm() > worth;
}

void PressedBody::take_state(PressedState& state) {
  due_ = false;
  last_corridor_ = moving_.places();
  state.places = moving_.places();
  state.held.assign(moving_.all_held().begin(), moving_.all_held().end());
}

std::shared_ptr<CondensedBody> PressedBody::make_corridor() {
  PressedState state;
  take_state(state);
  return make_corridor(state);
}

// Beside step(): of what that uses, this one reads what never changes and writes the plan's equations alone.
std::shared_ptr<CondensedBody> PressedBody::make_corridor(const PressedState& state, const Progress& progress) {
  FactorOptions options;
  options.keep_field = false;
  options.threads = 1;  // beside a tick and pictures
  options.memory_limit = settings_.memory_limit;
  for (const StressStiffness stress : {StressStiffness::exact, StressStiffness::positive}) {
    try {
      assemble_tangent(description_, state.places, state.held, stress, plan_.system);
      auto corridor = std::make_shared<CondensedBody>(plan_.corridor);
      corridor->compliance =
          MultifrontalCholesky(plan_.system.stiffness, plan_.symbolic, options, progress).last_compliance();
      for (std::size_t i = 0; i < corridor->nodes.size(); ++i)
        corridor->nodes[i] = state.places.col(corridor->mesh_nodes[i]).head<3>();
      return corridor;
    } catch (const NotPositiveDefinite&) {
      if (stress == StressStiffness::positive) return nullptr;
    } catch (const InputError&) {
      return nullptr;
    } catch (const std::bad_alloc&) {
      return nullptr;
    }
  }
  return nullptr;
}

}  // namespace bodkin
