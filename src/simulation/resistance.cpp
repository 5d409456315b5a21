#include "simulation/resistance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/repeatable.h"
#include "forces/needle_grasp.h"
#include "forces/prony_relaxation.h"
#include "forces/shaft_friction.h"
#include "simulation/force_part.h"
#include "simulation/resistance_models.h"
#include "simulation/touching_tissue.h"

namespace bodkin::simulation {

namespace {

// rad about the line: direction of the shaft's side, seen along the line.
double roll_about(const Vec3& line, const Vec3& side) noexcept {
  const Vec3 right = line.unitOrthogonal();
  return repeatable::atan2(side.dot(line.cross(right)), side.dot(right));
}

[[noreturn]] void refuse_part(std::string_view part, std::string_view model, const char* instead) {
  throw InputError(std::string(part) + " does not go with " + std::string(model) + "; " + instead);
}

// Throws InputError for a part that the model cannot have.
void check_parts(const anatomy::ForceParts& parts, const forces::ResistanceTraits& model) {
  if (!parts.relaxation.empty() && !model.can_relax && !model.relaxes_itself)
    refuse_part("relaxation", model.name,
                "use it with embedded_needle, spring_damper_wall, or tracking_wall without leash");
  if (parts.shaft_friction && model.has_shaft_friction)
    refuse_part("shaft_friction", model.name, "that model has its own friction of the shaft; leave the part out");
  if (parts.needle_grasp && !parts.shaft_friction && !model.uses_grip)
    refuse_part("needle_grasp", model.name, "it acts on the friction of the shaft; add the part shaft_friction");
}

}  // namespace

struct Resistance::State {
  State(const anatomy::Case& patient, double dt)
      : model(make_resistance(patient, dt)),
        relaxation(patient.description.haptics.parts.relaxation, dt),
        others(make_force_parts(patient, dt)),
        names(bodkin::simulation::diagnostic_names(patient.description.haptics)),
        model_names(forces::count_of(model->traits().diagnostics)),
        tissues(patient.tissues),
        deforms(goes_by_material(patient.description.haptics)) {
    const anatomy::ForceParts& parts = patient.description.haptics.parts;
    check_parts(parts, model->traits());
    relaxes = !parts.relaxation.empty() && model->traits().can_relax;
    if (parts.needle_grasp) grasp.emplace(*parts.needle_grasp);
    if (parts.shaft_friction) friction.emplace(patient, *parts.shaft_friction, dt, model->firm_stiffness());
  }

  std::unique_ptr<AnyResistance> model;
  forces::PronyRelaxation relaxation;
  bool relaxes = false;
  std::optional<forces::ShaftFrictionResistance> friction;
  std::optional<forces::NeedleGrasp> grasp;
  std::vector<std::unique_ptr<ForcePart>> others;  // the parts that are not above
  Vec3 direction = Vec3::UnitZ();                  // of the frozen line
  forces::TickEvents found;                        // events of the model, some of them reported by the tick
  double grip = 1.0, friction_force = 0.0;         // of the last tick
  std::vector<forces::DiagnosticName> names;
  std::size_t model_names;  // the first of them, those of the model
  const anatomy::TissueVolume& tissues;
  double material = 0.0;      // mm, of the last tick
  bool deforms;               // the tip's tissue is that of the deformed material
  Vec3 entry = Vec3::Zero();  // of the frozen line
};

Resistance::Resistance(const anatomy::Case& patient, double dt) : state_(std::make_unique<State>(patient, dt)) {}
Resistance::~Resistance() = default;
Resistance::Resistance(Resistance&&) noexcept = default;
Resistance& Resistance::operator=(Resistance&&) noexcept = default;

void Resistance::begin(const Vec3& entry, const Vec3& direction) noexcept {
  State& state = *state_;
  state.model->begin(entry, direction);
  state.entry = entry;
  state.direction = direction;
  state.relaxation.reset();
  if (state.friction) state.friction->begin(entry, direction);
  if (state.grasp) state.grasp->reset();
  for (const auto& part : state.others) part->begin(entry, direction);
}

forces::ResistanceForce Resistance::step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
  State& state = *state_;
  state.found.clear();
  if (state.grasp) {
    forces::NeedleInTissue held = needle;
    held.grip = state.grip = state.grasp->step(roll_about(state.direction, needle.side));
    return step_held(held, events);
  }
  return step_held(needle, events);
}

forces::ResistanceForce Resistance::step_held(const forces::NeedleInTissue& held,
                                              forces::TickEvents& events) noexcept {
  State& state = *state_;
  forces::ResistanceForce force = state.model->step(held, state.found);
  // Relaxed tissue that is unloaded does not pull the needle in.
  if (state.relaxes) force.along = std::max(0.0, state.relaxation.step(force.along));
  if (state.friction) {
    state.friction_force = state.friction->step(held, state.found).along;
    force.along += state.friction_force;
  }
  state.material = std::min(force.material, held.motion.depth);
  if (state.deforms && !state.others.empty()) {
    forces::NeedleInTissue inside = held;
    inside.tissue = force.inside != anatomy::tissue::air
                        ? force.inside
                        : touching_tissue(state.tissues, state.entry, state.direction, held.motion.depth,
                                          force.material, held.tissue);
    for (const auto& part : state.others) part->step(inside, force, state.found);
  } else {
    for (const auto& part : state.others) part->step(held, force, state.found);
  }
  for (const forces::Event& event : state.found) {
    // The tick reports contact and withdrawal; a fault is a motion that the tick does not pass on.
    if (event.kind == forces::EventKind::contact || event.kind == forces::EventKind::withdrawn ||
        event.kind == forces::EventKind::fault)
      continue;
    events.push(event);
  }
  return force;
}

void Resistance::reset() noexcept {
  State& state = *state_;
  state.model->reset();
  state.relaxation.reset();
  if (state.friction) state.friction->reset();
  if (state.grasp) state.grasp->reset();
  for (const auto& part : state.others) part->reset();
}

double Resistance::stiffness_scale() const noexcept {
  return state_->model->stiffness_scale();
}

bool Resistance::passes_layers() const noexcept {
  return state_->model->traits().passes_layers;
}

bool Resistance::has_lateral_force() const noexcept {
  return state_->model->traits().has_lateral_force;
}

std::span<const forces::DiagnosticName> Resistance::diagnostic_names() const noexcept {
  return state_->names;
}

void Resistance::publish(forces::Diagnostics& values) const noexcept {
  const State& state = *state_;
  if (state.names.empty()) return;
  std::size_t at = state.model_names;
  if (at > 0) {
    const forces::ModelDiagnostics of_model = state.model->diagnostics();
    std::copy_n(of_model.begin(), at, values.begin());
  }
  if (state.friction) values[at++] = state.friction_force;
  if (state.grasp) values[at++] = state.grip;
  for (const auto& part : state.others) at += part->publish(std::span(values).subspan(at));
  if (at < state.names.size()) values[at] = state.material;
}

BodyPort* Resistance::body() noexcept {
  return static_cast<BodyPort*>(state_->model->body());
}

}  // namespace bodkin::simulation
