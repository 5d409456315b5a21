#pragma once

#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "core/settings_tree.h"
#include "simulation/any_resistance.h"

namespace bodkin::simulation {

// A resistance that a case can choose by name. `make` reads the settings from the patient's description; it throws
// InputError as the model's constructor does.
struct ResistanceEntry {
  forces::ResistanceTraits traits;
  std::unique_ptr<AnyResistance> (*make)(const anatomy::Case& patient, double dt);
};

// All of Bodkin. To add a model: its file pair in forces, one line here (docs/adding-a-force-model.md).
std::span<const ResistanceEntry> resistance_models();

// Makes a model of the program itself known by the name in its traits, so that cases can choose it:
// `<registered name="NAME" SETTING="VALUE"/>`. Before the first case is simulated, from one thread. Throws InputError
// for a name that is taken.
void register_resistance(const ResistanceEntry& entry);

// The entry of a model whose settings the case gives as `<registered name="NAME" SETTING="VALUE"/>`, and which it
// reads with its own table of parameters (core/parameter.h).
template <forces::ResistanceModel Model>
requires Parameterized<typename Model::Settings>
constexpr ResistanceEntry registered_entry() {
  return {Model::traits, [](const anatomy::Case& patient, double dt) -> std::unique_ptr<AnyResistance> {
            const auto& chosen = std::get<anatomy::RegisteredSettings>(patient.description.haptics.resistance);
            const auto settings = settings_from<typename Model::Settings>(
                SettingsTree{.name = chosen.name, .values = chosen.values, .children = chosen.children},
                "resistance");
            return std::make_unique<ResistanceOf<Model>>(patient, settings, dt);
          }};
}

// Registers a class: `register_resistance<ConstantDrag>();`.
template <forces::ResistanceModel Model>
requires Parameterized<typename Model::Settings>
void register_resistance() {
  register_resistance(registered_entry<Model>());
}

// What the resistance of the settings and its parts publish each tick, in their order in TickOutput::diagnostics.
// The last is the depth in the material where the models go by it (goes_by_material).
std::vector<forces::DiagnosticName> diagnostic_names(const anatomy::HapticSettings& haptics);
inline constexpr std::string_view material_depth_name = "material_mm";

// The resistance that the description of the patient names.
std::unique_ptr<AnyResistance> make_resistance(const anatomy::Case& patient, double dt);

}  // namespace bodkin::simulation
