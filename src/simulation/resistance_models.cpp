#include "simulation/resistance_models.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <variant>

#include "core/error.h"
#include "forces/depth_profile.h"
#include "forces/fracture.h"
#include "forces/layered.h"
#include "forces/shaft_friction.h"
#include "forces/spring_damper_wall.h"
#include "forces/surface_proxy.h"
#include "forces/three_component.h"
#include "forces/tracking_wall.h"
#include "forces/tracking_wall_leash.h"
#include "forces/volume_proxy.h"
#include "simulation/deformable_resistance.h"
#include "simulation/force_part.h"
#include "simulation/needle_in_body.h"
#include "simulation/touching_tissue.h"

namespace bodkin::simulation {

namespace {

template <typename Settings>
const Settings& settings_of(const anatomy::Case& patient) {
  return std::get<Settings>(patient.description.haptics.resistance);
}

template <forces::ResistanceModel Model>
constexpr ResistanceEntry entry_of() {
  return {Model::traits, [](const anatomy::Case& patient, double dt) -> std::unique_ptr<AnyResistance> {
            return std::make_unique<ResistanceOf<Model>>(patient, settings_of<typename Model::Settings>(patient), dt);
          }};
}

// One name for two models: the wall stays on the line, or may leave it.
std::unique_ptr<AnyResistance> make_tracking_wall(const anatomy::Case& patient, double dt) {
  const auto& settings = settings_of<anatomy::TrackingWallSettings>(patient);
  if (settings.leash) return std::make_unique<ResistanceOf<forces::TrackingWallLeash>>(patient, settings, dt);
  return std::make_unique<ResistanceOf<forces::TrackingWall>>(patient, settings, dt);
}

// Of programs outside; filled before the first case that needs them.
std::vector<ResistanceEntry>& registered() {
  static std::vector<ResistanceEntry> entries;
  return entries;
}

constexpr ResistanceEntry models[] = {
    entry_of<forces::LayeredResistance>(),
    entry_of<forces::SpringDamperWall>(),
    {forces::TrackingWall::traits, make_tracking_wall},
    entry_of<forces::DepthProfile>(),
    entry_of<forces::VolumeProxy>(),
    entry_of<forces::ThreeComponent>(),
    entry_of<forces::Fracture>(),
    entry_of<forces::ShaftFrictionResistance>(),
    entry_of<forces::SurfaceProxyResistance>(),
    entry_of<NeedleInBody>(),
    entry_of<DeformableTip>(),
};

const ResistanceEntry* find(std::string_view name) {
  for (const ResistanceEntry& entry : models) {
    if (entry.traits.name == name) return &entry;
  }
  for (const ResistanceEntry& entry : registered()) {
    if (entry.traits.name == name) return &entry;
  }
  return nullptr;
}

const ResistanceEntry& entry_for(const anatomy::HapticSettings& haptics) {
  const std::string name(anatomy::model_name(haptics.resistance));
  if (const ResistanceEntry* found = find(name)) return *found;
  std::string names;
  for (const ResistanceEntry& entry : models) names += (names.empty() ? "" : ", ") + std::string(entry.traits.name);
  for (const ResistanceEntry& entry : registered()) names += ", " + std::string(entry.traits.name);
  throw InputError("there is no resistance '" + name + "' in this program, expected one of " + names);
}

}  // namespace

std::span<const ResistanceEntry> resistance_models() {
  return models;
}

void register_resistance(const ResistanceEntry& entry) {
  if (entry.traits.name.empty() || entry.make == nullptr)
    throw InputError("a resistance was registered without a name or without a way to make it");
  if (find(entry.traits.name) != nullptr) {
    throw InputError("there is a resistance '" + std::string(entry.traits.name) +
                     "' already; register it under another name");
  }
  registered().push_back(entry);
}

std::vector<forces::DiagnosticName> diagnostic_names(const anatomy::HapticSettings& haptics) {
  std::vector<forces::DiagnosticName> names;
  for (const forces::DiagnosticName& name : entry_for(haptics).traits.diagnostics) {
    if (!name.name.empty()) names.push_back(name);
  }
  if (haptics.parts.shaft_friction) names.push_back({"shaft_friction_N", "friction of the shaft"});
  if (haptics.parts.needle_grasp) names.push_back({"grip", "factor on the friction of the shaft"});
  for (const forces::DiagnosticName& name : force_part_diagnostics(haptics.parts)) names.push_back(name);
  if (goes_by_material(haptics) && names.size() < forces::most_diagnostics)
    names.push_back({material_depth_name, "depth in the tissue at rest"});
  return names;
}

std::unique_ptr<AnyResistance> make_resistance(const anatomy::Case& patient, double dt) {
  return entry_for(patient.description.haptics).make(patient, dt);
}

}  // namespace bodkin::simulation
