#include "simulation/resistance_models.h"

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/error.h"
#include "simulation/deformable_resistance.h"
#include "simulation/force_part.h"
#include "simulation/needle_in_body.h"
#include "simulation/touching_tissue.h"

namespace bodkin::simulation {

namespace {

// The models of a deformable body are constructed here; the sources of the others state which settings they have.
template <typename Settings>
ResistanceEntry resistance_with() {
  if constexpr (std::is_same_v<Settings, anatomy::EmbeddedNeedleSettings>)
    return forces::entry_of<NeedleInBody>();
  else if constexpr (std::is_same_v<Settings, anatomy::ClosestNodeSettings>)
    return forces::entry_of<DeformableTip>();
  else
    return forces::resistance_with<Settings>();
}

constexpr std::size_t own_models = std::variant_size_v<anatomy::ResistanceSettings> - 1;
static_assert(anatomy::resistance_names[own_models] == "registered", "it is the last of the list");

// All models of Bodkin, then those that other programs register before the first case that needs them.
std::vector<ResistanceEntry>& models() {
  static std::vector<ResistanceEntry> entries = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::vector{resistance_with<std::variant_alternative_t<I, anatomy::ResistanceSettings>>()...};
  }
  (std::make_index_sequence<own_models>());
  return entries;
}

const ResistanceEntry* find(std::string_view name) {
  for (const ResistanceEntry& entry : models()) {
    if (entry.traits.name == name) return &entry;
  }
  return nullptr;
}

const ResistanceEntry& entry_for(const anatomy::HapticSettings& haptics) {
  const std::string name(anatomy::model_name(haptics.resistance));
  if (const ResistanceEntry* found = find(name)) return *found;
  std::string names;
  for (const ResistanceEntry& entry : models()) names += (names.empty() ? "" : ", ") + std::string(entry.traits.name);
  throw InputError("there is no resistance '" + name + "' in this program, expected one of " + names);
}

}  // namespace

std::span<const ResistanceEntry> resistance_models() {
  return std::span(models()).first<own_models>();
}

void register_resistance(const ResistanceEntry& entry) {
  if (entry.traits.name.empty() || entry.make == nullptr)
    throw InputError("a resistance was registered without a name or without a way to make it");
  if (find(entry.traits.name) != nullptr) {
    throw InputError("there is a resistance '" + std::string(entry.traits.name) +
                     "' already; register it under another name");
  }
  models().push_back(entry);
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
