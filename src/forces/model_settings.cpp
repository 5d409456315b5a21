#include "forces/model_settings.h"

#include <variant>

#include "forces/needle_law.h"

namespace bodkin::forces {

ModelSettings model_settings(const anatomy::Case& patient) {
  return model_settings(patient.description, patient.library);
}

ModelSettings model_settings(const anatomy::CaseDescription& description, const anatomy::TissueLibrary& library) {
  if (description.haptics.mechanics == anatomy::Mechanics::tables) return {description.haptics, library.tissues()};
  anatomy::Case of;
  of.description = description;
  of.library = library;
  ModelSettings settings{description.haptics, effective_tissues(of).tissues()};
  std::visit(
      [&of](auto& resistance) {
        if constexpr (requires { felt_settings(resistance, of); }) resistance = felt_settings(resistance, of);
      },
      settings.haptics.resistance);
  for (anatomy::TissueProperties& tissue : settings.tissues)
    tissue.physical.puncture_force = tissue.physical.friction = 0.0;  // the input of is_described()
  return settings;
}

}  // namespace bodkin::forces
