#pragma once

#include <memory>
#include <span>
#include <vector>

#include "simulation/any_resistance.h"

namespace bodkin {

// A resistance that a case can choose by name. `make` reads the settings from the patient's description; it throws
// InputError as the model's constructor does.
struct ResistanceEntry {
  ResistanceTraits traits;
  std::unique_ptr<AnyResistance> (*make)(const Case& patient, double dt);
};

// All of them. To add a model: its file pair in forces, one line here (docs/adding-a-force-model.md).
std::span<const ResistanceEntry> resistance_models();

// What the resistance of the settings and its parts publish each tick, in their order in TickOutput::diagnostics.
std::vector<DiagnosticName> diagnostic_names(const HapticSettings& haptics);

// The resistance that the description of the patient names.
std::unique_ptr<AnyResistance> make_resistance(const Case& patient, double dt);

}  // namespace bodkin
