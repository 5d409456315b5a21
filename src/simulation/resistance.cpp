#include "simulation/resistance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/error.h"
#include "forces/depth_profile.h"
#include "forces/fracture.h"
#include "forces/haptic_field.h"
#include "forces/layered.h"
#include "forces/model_input.h"
#include "forces/needle_grasp.h"
#include "forces/prony_relaxation.h"
#include "forces/shaft_friction.h"
#include "forces/spring_damper_wall.h"
#include "forces/three_component.h"
#include "forces/tissue_path.h"
#include "forces/tracking_wall.h"
#include "forces/tracking_wall_leash.h"
#include "forces/volume_proxy.h"
#include "simulation/corridors.h"
#include "simulation/deformable_resistance.h"
#include "simulation/device_stability.h"

namespace bodkin {

namespace {

constexpr double longest_path = 400.0;    // mm; deeper is as 400 mm
constexpr double friction_layer = 0.5;    // mm between tissue samples of models that know no layers
constexpr double least_hold_share = 0.1;  // of the device's stiffness, left to the friction's spring

void require_stable_tissues(const char* model, const Case& patient, double (*stiffness)(const TissueProperties&)) {
  for (const TissueProperties& tissue : patient.library.tissues()) {
    require_stable(model, "the spring of " + tissue.title, stiffness(tissue), patient.description.device);
  }
}

// Models whose force is one number along the line, from the motion and the tissue at the tip.
template <typename Model>
struct Axial {
  Model model;
  double stiffness = 0.0;  // N/mm, for the stiffness warning; 0: unknown

  void begin(const Vec3& entry, const Vec3& direction) noexcept { model.begin(entry, direction); }
  void reset() noexcept { model.reset(); }
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept {
    const double force = model.step(needle.motion, needle.tissue, events);
    return {.along = force, .stiffness = force > 0.0 ? stiffness : 0.0, .in_contact = needle.motion.depth > 0.0};
  }
};

struct Wall {
  SpringDamperWall model;
  double stiffness;

  void begin(const Vec3&, const Vec3&) noexcept {}
  void reset() noexcept { model.reset(); }
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept {
    const double force = model.step(needle.motion, needle.tissue, events);
    return {.along = force, .stiffness = force > 0.0 ? stiffness : 0.0, .in_contact = needle.motion.depth > 0.0};
  }
};

struct Leash {
  TrackingWallLeash model;
  Vec3 direction = Vec3::UnitZ();

  void begin(const Vec3& entry, const Vec3& along) noexcept {
    model.begin(entry, along);
    direction = along;
  }
  void reset() noexcept { model.reset(); }
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept {
    const Vec3 force = model.step(needle.tip, needle.motion, needle.tissue, events);
    const double along = -force.dot(direction);
    return {.along = along, .across = force + along * direction, .in_contact = needle.motion.depth > 0.0};
  }
};

struct Proxy {
  std::unique_ptr<HapticField> field;
  VolumeProxy model;
  double stiffness;
  Vec3 direction = Vec3::UnitZ();

  void begin(const Vec3&, const Vec3& along) noexcept {
    model.reset();
    direction = along;
  }
  void reset() noexcept { model.reset(); }
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept {
    const Vec3 force = model.step(needle.tip, needle.rail, events);
    const double along = -force.dot(direction);
    return {.along = along,
            .across = force + along * direction,
            .stiffness = stiffness,
            .in_contact = needle.motion.depth > 0.0};
  }
};

// The tissues along the line and the friction that they have on the shaft.
struct Friction {
  Friction(const Case& patient, const ShaftFrictionSettings& settings, double firm)
      : model(settings),
        tissues(patient.library.by_id(&TissueProperties::shaft_friction)),
        path(friction_layer, longest_path),
        volume(&patient.tissues),
        budget(std::max(patient.description.device.stiffness - firm,
                        least_hold_share * patient.description.device.stiffness)) {
    for (const TissueProperties& tissue : patient.library.tissues()) {
      const ShaftFrictionTissue& here = tissue.shaft_friction;
      const std::string of = " of " + tissue.title;
      check_setting("shaft_friction", "Coulomb friction" + of, "N/mm", here.coulomb, 0.0, 10.0);
      check_setting("shaft_friction", "static friction" + of, "N/mm", here.static_force, here.coulomb, 10.0);
      check_setting("shaft_friction", "stiffness" + of, "N/mm^2", here.stiffness, 1e-6, 100.0);
      check_setting("shaft_friction", "viscous friction" + of, "N s/mm^2", here.viscous, 0.0, 1.0);
    }
  }

  void begin(const Vec3& entry, const Vec3& direction) noexcept {
    path.restart(entry, direction);
    model.begin();
  }
  void reset() noexcept { model.reset(); }
  double step(const NeedleInTissue& needle, double grip, TickEvents& events) noexcept {
    const double depth = std::min(needle.motion.depth, longest_path);
    path.extend_to(depth, *volume);
    ShaftContact contact = shaft_contact(path.layers(), friction_layer, depth, tissues);
    contact.coulomb *= grip;
    contact.static_force *= grip;
    contact.stiffness =
        std::min(contact.stiffness * grip, budget);  // a long shaft stretches tissue over a longer way
    return model.step(needle.motion, contact, events);
  }
  ResistanceForce force(const NeedleInTissue& needle, double grip, TickEvents& events) noexcept {
    return {.along = step(needle, grip, events), .in_contact = needle.motion.depth > 0.0};
  }

  ShaftFriction model;
  std::array<ShaftFrictionTissue, 256> tissues;  // 256, by TissueId
  TissuePath path;
  const TissueVolume* volume;
  double budget;  // N/mm that the tissue's spring on the shaft may have
};

struct Layers {
  Layers(const Case& patient, const LayeredSettings& settings, double dt)
      : model(patient.library, settings, patient.description.device.stiffness, dt, longest_path),
        path(settings.layer, longest_path),
        volume(&patient.tissues) {}

  void begin(const Vec3& entry, const Vec3& direction) noexcept {
    path.restart(entry, direction);
    model.begin();
  }
  void reset() noexcept { model.begin(); }
  ResistanceForce step(const NeedleInTissue& needle, double grip, TickEvents& events) noexcept {
    path.extend_to(std::min(needle.motion.depth + model.look_ahead(), longest_path), *volume);
    const LayeredForce found = model.step(needle.motion, path.layers(), events, grip);
    return {.along = found.resistance, .stiffness = found.stiffness, .in_contact = found.in_contact};
  }

  Layered model;
  TissuePath path;
  const TissueVolume* volume;
};

using Shafts = Corridors<DeformableShaft, EmbeddedNeedleSettings>;
using Tips = Corridors<DeformableTip, ClosestNodeSettings>;

using Model = std::variant<Layers, Wall, Axial<TrackingWall>, Leash, Axial<DepthProfile>, Proxy,
                           Axial<ThreeComponent>, Axial<Fracture>, Friction, Shafts, Tips>;

// Builds the model that the settings ask for, after checks that need the device.
struct Maker {
  const Case& patient;
  double dt;

  const DeviceLimits& device() const { return patient.description.device; }

  Model operator()(const LayeredSettings& settings) const { return Layers(patient, settings, dt); }
  Model operator()(const SpringDamperWallSettings& settings) const {
    SpringDamperWall model(settings);
    require_stable("spring_damper_wall", "stiffness", settings.stiffness, device());
    require_stable_damping("spring_damper_wall", settings.stiffness, settings.damping, device(), dt);
    return Wall{model, settings.stiffness};
  }
  Model operator()(const TrackingWallSettings& settings) const {
    require_stable_tissues("tracking_wall", patient,
                           [](const TissueProperties& tissue) { return tissue.tracking_wall.stiffness; });
    for (const TrackingWallDepthLayer& layer : settings.layers)
      require_stable("tracking_wall", "the spring of a layer", layer.layer.stiffness, device());
    if (settings.leash) return Leash{TrackingWallLeash(patient.library, settings, dt)};
    return Axial<TrackingWall>{TrackingWall(patient.library, settings, dt)};
  }
  Model operator()(const DepthProfileSettings& settings) const {
    require_stable("depth_profile", "skin stiffness", settings.skin_stiffness, device());
    require_stable("depth_profile", "bone stiffness", settings.bone_stiffness, device());
    require_stable_tissues("depth_profile", patient,
                           [](const TissueProperties& tissue) { return tissue.depth_profile.stiffness; });
    return Axial<DepthProfile>{DepthProfile(patient.library, settings, dt)};
  }
  Model operator()(const VolumeProxySettings& settings) const {
    require_stable("volume_proxy", "stiffness", settings.stiffness, device());
    auto field = std::make_unique<HapticField>(patient.ct, patient.tissues, patient.library, settings.field);
    VolumeProxy model(patient.library, settings, *field, dt);
    return Proxy{std::move(field), std::move(model), settings.stiffness};
  }
  Model operator()(const ThreeComponentSettings& settings) const {
    ThreeComponent model(settings);
    require_stable("three_component", "cutting stiffness", settings.cutting_stiffness, device());
    // R = a1 x + a2 x^2 has its steepest slope where it breaks: dR/dx = sqrt(a1^2 + 4 a2 R).
    require_stable("three_component", "the stiffness at which the capsule gives way",
                   std::sqrt(settings.linear * settings.linear + 4.0 * settings.quadratic * settings.puncture_force),
                   device());
    return Axial<ThreeComponent>{std::move(model)};
  }
  Model operator()(const FractureSettings& settings) const {
    Fracture model(settings);
    require_stable("fracture", "cutting stiffness", settings.cutting_stiffness, device());
    require_stable("fracture", "the stiffness at which the membrane tears", model.stiffness_at_rupture(), device());
    return Axial<Fracture>{std::move(model)};
  }
  Model operator()(const ShaftFrictionSettings& settings) const { return Friction(patient, settings, 0.0); }
  Model operator()(const EmbeddedNeedleSettings& settings) const { return Shafts(patient, settings, dt); }
  Model operator()(const ClosestNodeSettings& settings) const { return Tips(patient, settings, dt); }
};

// The stiffness along the line that a friction part has to share the device with.
double firm_stiffness(const ResistanceSettings& settings, const Case& patient) {
  const auto stiffest = [&](auto stiffness) {
    double most = 0.0;
    for (const TissueProperties& tissue : patient.library.tissues()) most = std::max(most, stiffness(tissue));
    return most;
  };
  if (const auto* wall = std::get_if<SpringDamperWallSettings>(&settings)) return wall->stiffness;
  if (std::holds_alternative<TrackingWallSettings>(settings))
    return stiffest([](const TissueProperties& tissue) { return tissue.tracking_wall.stiffness; });
  if (const auto* profile = std::get_if<DepthProfileSettings>(&settings)) {
    return std::max({profile->bone_stiffness, profile->skin_stiffness,
                     stiffest([](const TissueProperties& tissue) { return tissue.depth_profile.stiffness; })});
  }
  if (const auto* proxy = std::get_if<VolumeProxySettings>(&settings)) return proxy->stiffness;
  if (const auto* fracture = std::get_if<FractureSettings>(&settings)) return fracture->cutting_stiffness;
  return 0.0;
}

// rad about the line: where the shaft's side points, seen along the line.
double roll_about(const Vec3& line, const Vec3& side) noexcept {
  const Vec3 right = line.unitOrthogonal();
  return std::atan2(side.dot(line.cross(right)), side.dot(right));
}

[[noreturn]] void refuse_part(std::string_view part, std::string_view model, const char* instead) {
  throw InputError(std::string(part) + " does not go with " + std::string(model) + "; " + instead);
}

void check_parts(const HapticSettings& haptics) {
  const std::string_view model = name_of(haptics.resistance);
  const ForceParts& parts = haptics.parts;
  const auto* tracking = std::get_if<TrackingWallSettings>(&haptics.resistance);
  const bool relaxes = std::holds_alternative<SpringDamperWallSettings>(haptics.resistance) ||
                       (tracking != nullptr && !tracking->leash);
  if (!parts.relaxation.empty() && !relaxes)
    refuse_part("relaxation", model, "use it with spring_damper_wall, or with tracking_wall without leash");
  const bool has_friction = model == "layered" || model == "three_component" || model == "shaft_friction" ||
                            body_of(haptics.resistance) != nullptr;
  if (parts.shaft_friction && has_friction)
    refuse_part("shaft_friction", model, "that model has a friction of the shaft of its own; leave the part out");
  if (parts.needle_grasp && !parts.shaft_friction && model != "layered" && model != "shaft_friction")
    refuse_part("needle_grasp", model, "it acts on the friction of the shaft; add the part shaft_friction");
}

}  // namespace

struct Resistance::State {
  State(const Case& patient, double dt)
      : model(std::visit(Maker{patient, dt}, patient.description.haptics.resistance)),
        relaxation(patient.description.haptics.parts.relaxation, dt) {
    const HapticSettings& haptics = patient.description.haptics;
    check_parts(haptics);
    relaxes = !haptics.parts.relaxation.empty();
    if (haptics.parts.needle_grasp) grasp.emplace(*haptics.parts.needle_grasp);
    if (haptics.parts.shaft_friction)
      friction.emplace(patient, *haptics.parts.shaft_friction, firm_stiffness(haptics.resistance, patient));
  }

  ResistanceForce model_step(const NeedleInTissue& needle, double grip, TickEvents& events) noexcept;

  Model model;
  PronyRelaxation relaxation;
  bool relaxes = false;
  std::optional<Friction> friction;
  std::optional<NeedleGrasp> grasp;
  Vec3 direction = Vec3::UnitZ();  // of the frozen line
  TickEvents found;                // events of the model, of which some are the tick's to report
};

ResistanceForce Resistance::State::model_step(const NeedleInTissue& needle, double grip,
                                              TickEvents& events) noexcept {
  return std::visit(
      [&](auto& one) {
        using One = std::decay_t<decltype(one)>;
        if constexpr (std::is_same_v<One, Layers>) {
          return one.step(needle, grip, events);
        } else if constexpr (std::is_same_v<One, Friction>) {
          return one.force(needle, grip, events);
        } else {
          return one.step(needle, events);
        }
      },
      model);
}

Resistance::Resistance(const Case& patient, double dt) : state_(std::make_unique<State>(patient, dt)) {}
Resistance::~Resistance() = default;
Resistance::Resistance(Resistance&&) noexcept = default;
Resistance& Resistance::operator=(Resistance&&) noexcept = default;

void Resistance::begin(const Vec3& entry, const Vec3& direction) noexcept {
  State& state = *state_;
  std::visit([&](auto& one) { one.begin(entry, direction); }, state.model);
  state.direction = direction;
  state.relaxation.reset();
  if (state.friction) state.friction->begin(entry, direction);
  if (state.grasp) state.grasp->reset();
}

ResistanceForce Resistance::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  State& state = *state_;
  state.found.clear();
  const double grip = state.grasp ? state.grasp->step(roll_about(state.direction, needle.side)) : 1.0;
  ResistanceForce force = state.model_step(needle, grip, state.found);
  // Relaxed tissue that is unloaded does not pull the needle in.
  if (state.relaxes) force.along = std::max(0.0, state.relaxation.step(force.along));
  if (state.friction) force.along += state.friction->step(needle, grip, state.found);
  for (const Event& event : state.found) {
    // Contact and withdrawal are the tick's to say; a fault is a motion that the tick does not let through.
    if (event.kind == EventKind::contact || event.kind == EventKind::withdrawn || event.kind == EventKind::fault)
      continue;
    events.push(event);
  }
  return force;
}

void Resistance::reset() noexcept {
  State& state = *state_;
  std::visit([](auto& one) { one.reset(); }, state.model);
  state.relaxation.reset();
  if (state.friction) state.friction->reset();
  if (state.grasp) state.grasp->reset();
}

double Resistance::stiffness_scale() const noexcept {
  if (const auto* layers = std::get_if<Layers>(&state_->model)) return layers->model.stiffness_scale();
  if (const auto* shafts = std::get_if<Shafts>(&state_->model)) return shafts->model().stiffness_scale();
  if (const auto* tips = std::get_if<Tips>(&state_->model)) return tips->model().stiffness_scale();
  return 1.0;
}

bool Resistance::add_corridor(const PreparedCorridor& corridor) {
  if (auto* shafts = std::get_if<Shafts>(&state_->model)) return shafts->add(corridor);
  if (auto* tips = std::get_if<Tips>(&state_->model)) return tips->add(corridor);
  return false;
}

bool Resistance::refresh_corridor(const PreparedCorridor& corridor) {
  auto* shafts = std::get_if<Shafts>(&state_->model);
  if (shafts != nullptr) shafts->refresh(corridor);
  return shafts != nullptr;
}

void Resistance::stay_at_rest() noexcept {
  if (auto* shafts = std::get_if<Shafts>(&state_->model)) shafts->stay_at_rest();
}

NodeForces Resistance::node_forces() const noexcept {
  if (const auto* shafts = std::get_if<Shafts>(&state_->model)) return shafts->model().node_forces();
  if (const auto* tips = std::get_if<Tips>(&state_->model)) return tips->model().node_forces();
  return {};
}

Vec3 Resistance::ahead() const noexcept {
  if (const auto* shafts = std::get_if<Shafts>(&state_->model)) return shafts->model().ahead();
  if (const auto* tips = std::get_if<Tips>(&state_->model)) return tips->model().ahead();
  return Vec3::Zero();
}

bool Resistance::holds_laterally() const noexcept {
  return std::holds_alternative<Proxy>(state_->model) || std::holds_alternative<Shafts>(state_->model);
}

}  // namespace bodkin
