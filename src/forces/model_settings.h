#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "anatomy/case.h"
#include "core/parameter.h"

namespace bodkin::forces {

// Everything about a force model that a person may change.
struct ModelSettings {
  anatomy::HapticSettings haptics;
  std::vector<anatomy::TissueProperties> tissues;
};

// As the case feels. What a person changes are the models' own numbers: with mechanics="physical" those that follow
// from the description for the case's needle stand in place of the description, which would be derived again.
ModelSettings model_settings(const anatomy::Case& patient);
// The same of a case with this description and these tissues.
ModelSettings model_settings(const anatomy::CaseDescription& description, const anatomy::TissueLibrary& library);

// Which struct of them a parameter stands in. From `relaxation` on: what a case adds to its resistance.
enum class ModelPart : std::uint8_t {
  resistance,
  constraint,
  weight,
  tissue,
  relaxation,
  shaft_friction,
  needle_grasp,
  bevel_tip,
  csf_flow,
  syringe,
  fingertip
};
inline constexpr std::array<ModelPart, 7> added_parts = {
    ModelPart::relaxation, ModelPart::shaft_friction, ModelPart::needle_grasp, ModelPart::bevel_tip,
    ModelPart::csf_flow,   ModelPart::syringe,        ModelPart::fingertip};

// Calls visit(struct) with the one of `parts` that is meant, if it is there; of `relaxation` that with this index.
template <typename Parts, typename Visit>
void visit_added_part(Parts& parts, ModelPart part, std::size_t index, const Visit& visit) {
  const auto open = [&](auto& value) {
    if (value) visit(*value);
  };
  switch (part) {
    case ModelPart::relaxation:
      if (index < parts.relaxation.size()) visit(parts.relaxation[index]);
      return;
    case ModelPart::shaft_friction:
      return open(parts.shaft_friction);
    case ModelPart::needle_grasp:
      return open(parts.needle_grasp);
    case ModelPart::bevel_tip:
      return open(parts.bevel_tip);
    case ModelPart::csf_flow:
      return open(parts.csf_flow);
    case ModelPart::syringe:
      return open(parts.syringe);
    case ModelPart::fingertip:
      return open(parts.fingertip);
    default:
      return;
  }
}

// Calls visit(struct) with the one that is meant, as long as it has a table of parameters. Of a tissue (`id`) it is
// what the resistance asks of it, and nothing where it asks for nothing; of `relaxation` the one with the index `id`;
// of another part that the case does not have it is nothing. `Settings` may be const.
template <typename Settings, typename Visit>
void visit_part(Settings& settings, ModelPart part, anatomy::TissueId id, const Visit& visit) {
  const auto open = [&](auto& value) {
    if constexpr (Parameterized<std::remove_cvref_t<decltype(value)>>) visit(value);
  };
  switch (part) {
    case ModelPart::resistance:
      return std::visit(open, settings.haptics.resistance);
    case ModelPart::constraint:
      return std::visit(open, settings.haptics.constraint);
    case ModelPart::weight:
      return visit(settings.haptics.compensation);
    case ModelPart::tissue:
      break;
    default:
      return visit_added_part(settings.haptics.parts, part, id, visit);
  }
  const auto found = std::find_if(settings.tissues.begin(), settings.tissues.end(),
                                  [id](const anatomy::TissueProperties& tissue) { return tissue.id == id; });
  if (found == settings.tissues.end()) return;
  // What a tissue says to a model is the element of the model's name; all models of a deformable body share one.
  const bool has_body = anatomy::body_of(settings.haptics.resistance) != nullptr;
  const std::string_view asked = has_body ? "deformable" : anatomy::name_of(settings.haptics.resistance);
  for_each_inside(
      [&](const auto& element, auto& value) {
        if (element.name == asked) visit(value);
      },
      *found);
}

}  // namespace bodkin::forces
