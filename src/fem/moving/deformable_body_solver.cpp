#include "fem/moving/deformable_body_solver.h"

#include <algorithm>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/multifrontal_cholesky.h"

namespace bodkin::fem {

namespace {

constexpr int most_steps_to_rest = 100;  // of Newton, of the body without a needle
constexpr double at_rest_part = 0.1;     // of BodySolverSettings::settled, below which a step has come to rest

const BodySolverSettings& checked_pressed_settings(const BodySolverSettings& settings) {
  if (!(settings.settled > 0.0 && settings.worth > 0.0)) {
    throw InputError(
        fmt::format("moving body: settled is {} mm and worth {} mm, expected both above 0; 0.05 and 0.5 are usual",
                    settings.settled, settings.worth));
  }
  return settings;
}

}  // namespace

DeformableBodySolver::DeformableBodySolver(const BodyDescription& body, const BodySolverSettings& settings)
    : settings_(checked_pressed_settings(settings)),
      description_(body),
      moving_(description_, settings.motion),
      press_(description_.mesh, description_.fixed, settings.probe),
      plan_(plan_body(description_)),
      last_corridor_(moving_.places()),
      last_held_(moving_.all_held().begin(), moving_.all_held().end()) {}

const CorotationalStep& DeformableBodySolver::step(const std::optional<Pose>& probe,
                                                   const NodeForces& needle) noexcept {
  if (probe) {
    press_.press(*probe, moving_);
  } else {
    press_.lift(moving_);
  }
  moving_.clear_loads();
  for (std::size_t i = 0; i < std::min(needle.count, NodeForces::capacity); ++i) {
    const NodeForce& on = needle.nodes[i];
    if (on.node < moving_.nodes()) moving_.load(on.node, Vec3(on.force[0], on.force[1], on.force[2]));
  }
  const CorotationalStep& step = moving_.step();
  press_.let_go_what_is_pulled(moving_);
  settled_ = !step.fault && step.largest_move <= settings_.settled;
  judge(needle.count > 0);
  return step;
}

void DeformableBodySolver::judge(bool needle) noexcept {
  due_ = false;
  needle_ = needle;
  if (!settled_) return;
  const double worth = settings_.worth * settings_.worth;
  for (std::uint32_t node = 0; node < moving_.nodes() && !due_; ++node) {
    const bool by_probe = moving_.held(node) || last_held_[node] != 0;
    due_ = (by_probe || !needle) && (moving_.places().col(node) - last_corridor_.col(node)).squaredNorm() > worth;
  }
}

void DeformableBodySolver::take_state(BodyState& state) {
  due_ = false;
  last_corridor_ = moving_.places();
  std::copy(moving_.all_held().begin(), moving_.all_held().end(), last_held_.begin());
  state.places = moving_.places();
  state.held = last_held_;
  state.needle = needle_;
}

std::shared_ptr<anatomy::CondensedBody> DeformableBodySolver::make_corridor() {
  BodyState state;
  take_state(state);
  return make_corridor(state);
}

// Where the body would come to rest if the probe stayed and the needle were not there.
bool DeformableBodySolver::find_free(const BodyState& state, const Progress& progress) {
  if (!free_) {
    CorotationalSettings at_rest = settings_.motion;
    at_rest.dt = 0.0;
    free_.emplace(description_, at_rest);
  }
  for (std::uint32_t node = 0; node < free_->nodes(); ++node) free_->release(node);
  if (!free_->place(state.places.topRows<3>())) return false;
  for (std::uint32_t node = 0; node < free_->nodes(); ++node) {
    if (state.held[node] != 0) free_->hold(node, state.places.col(node).head<3>());
  }
  for (int step = 0; step < most_steps_to_rest; ++step) {
    if (progress) progress("the body without the needle", 0.0);
    const CorotationalStep& done = free_->step();
    if (done.fault) return false;
    if (done.largest_move < at_rest_part * settings_.settled) return true;
  }
  return false;
}

std::shared_ptr<anatomy::CondensedBody> DeformableBodySolver::condense_about(const NodeVectors& places,
                                                                             std::span<const std::uint8_t> held,
                                                                             const Progress& progress) {
  FactorOptions options;
  options.keep_field = false;
  options.threads = 1;  // in addition to the tick and the display
  options.memory_limit = settings_.memory_limit;
  for (const StressStiffness stress : {StressStiffness::exact, StressStiffness::positive}) {
    try {
      assemble_tangent(description_, places, held, stress, plan_.system);
      auto corridor = std::make_shared<anatomy::CondensedBody>(plan_.corridor);
      corridor->compliance =
          MultifrontalCholesky(plan_.system.stiffness, plan_.symbolic, options, progress).last_compliance();
      for (std::size_t i = 0; i < corridor->nodes.size(); ++i)
        corridor->nodes[i] = places.col(corridor->mesh_nodes[i]).head<3>();
      return corridor;
    } catch (const NotPositiveDefinite&) {
      if (stress == StressStiffness::positive) return nullptr;
    }
  }
  return nullptr;
}

// May run in parallel with step(): it reads what never changes, and writes the corridor, its plan's equations
// and the body without a needle, which are its own.
std::shared_ptr<anatomy::CondensedBody> DeformableBodySolver::make_corridor(const BodyState& state,
                                                                            const Progress& progress,
                                                                            std::vector<std::uint32_t> nodes) {
  std::optional<BodyPlan> before;
  try {
    if (state.needle && !find_free(state, progress)) return nullptr;
    const auto unknown = [this](std::uint32_t node) { return node >= description_.mesh.nodes.size(); };
    if (std::any_of(nodes.begin(), nodes.end(), unknown)) return nullptr;
    if (!nodes.empty() && nodes != plan_.corridor.mesh_nodes) {
      description_.corridor.swap(nodes);
      BodyPlan plan = plan_body(description_, progress);
      before = std::exchange(plan_, std::move(plan));
    }
    auto corridor = condense_about(state.needle ? free_->places() : state.places, state.held, progress);
    if (corridor != nullptr) return corridor;
  } catch (const InputError&) {
  } catch (const std::bad_alloc&) {
  }
  if (before) plan_ = std::move(*before);
  return nullptr;
}

}  // namespace bodkin::fem
