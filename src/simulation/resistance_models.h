#pragma once

#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "core/settings_tree.h"
#include "forces/resistance_model.h"

namespace bodkin::simulation {

using forces::AnyResistance;
using forces::ResistanceEntry;

// All models of Bodkin, in the order of the list in anatomy/resistance_settings.h (docs/adding-a-force-model.md).
std::span<const ResistanceEntry> resistance_models();

// Registers a model of the calling program under the name in its traits, so that cases can choose it: `<registered
// name="NAME" SETTING="VALUE"/>`. Call it before the first case is simulated, from one thread. Throws InputError for
// a name in use.
void register_resistance(const ResistanceEntry& entry);

// The entry of a model whose settings a case states as `<registered name="NAME" SETTING="VALUE"/>`, read with the
// model's own parameter table (core/parameter.h).
template <forces::ResistanceModel Model>
requires Parameterized<typename Model::Settings>
constexpr ResistanceEntry registered_entry() {
  return {Model::traits, [](const anatomy::Case& patient, double dt) -> std::unique_ptr<AnyResistance> {
            const auto& chosen = std::get<anatomy::RegisteredSettings>(patient.description.haptics.resistance);
            const auto settings = settings_from<typename Model::Settings>(
                SettingsTree{.name = chosen.name, .values = chosen.values, .children = chosen.children},
                "resistance");
            return std::make_unique<forces::ResistanceOf<Model>>(patient, settings, dt);
          }};
}

// Registers a class: `register_resistance<ConstantDrag>();`.
template <forces::ResistanceModel Model>
requires Parameterized<typename Model::Settings>
void register_resistance() {
  register_resistance(registered_entry<Model>());
}

// The diagnostics of the settings' resistance and its parts, in their order in TickOutput::diagnostics. The last is
// the depth in the material for models that use it (goes_by_material).
std::vector<forces::DiagnosticName> diagnostic_names(const anatomy::HapticSettings& haptics);
inline constexpr std::string_view material_depth_name = "material_mm";

// Creates the resistance named in the patient's description.
std::unique_ptr<AnyResistance> make_resistance(const anatomy::Case& patient, double dt);

}  // namespace bodkin::simulation
