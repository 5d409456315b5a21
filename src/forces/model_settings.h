#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "anatomy/case.h"
#include "core/parameter.h"

namespace bodkin::forces {

// Everything that a person may change about a force model.
struct ModelSettings {
  anatomy::HapticSettings haptics;
  std::vector<anatomy::TissueProperties> tissues;
};

// The settings of a case. A person changes the models' own numbers: with mechanics="physical" the numbers derived for
// the case's needle replace the physical description, which would otherwise be derived again.
ModelSettings model_settings(const anatomy::Case& patient);
// As above, for a case with this description and these tissues.
ModelSettings model_settings(const anatomy::CaseDescription& description, const anatomy::TissueLibrary& library);

// The struct to which a parameter belongs. From `relaxation` on: parts that a case adds to its resistance, in the
// order of the table of ForceParts.
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
inline constexpr auto added_parts = [] {
  std::array<ModelPart, std::tuple_size_v<decltype(anatomy::ForceParts::parameters())>> parts{};
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i] = static_cast<ModelPart>(static_cast<std::size_t>(ModelPart::relaxation) + i);
  return parts;
}();
static_assert(added_parts.back() == ModelPart::fingertip, "ModelPart names each part of ForceParts");

// Calls visit(struct) with the selected one of `parts`, if it exists; for `relaxation` the one with this index.
template <typename Parts, typename Visit>
void visit_added_part(Parts& parts, ModelPart part, std::size_t index, const Visit& visit) {
  auto each = added_parts.begin();
  for_each_inside(
      [&](const auto& entry, auto& value) {
        if (*each++ != part) return;
        if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>) {
          if (index < value.size()) visit(value[index]);
        } else if (value) {
          visit(*value);
        }
      },
      parts);
}

// Calls visit(struct) with the selected struct, if it has a parameter table. For a tissue (`id`) that is what the
// resistance reads from it, or nothing; for `relaxation` the term with index `id`; for a part that the case does not
// have, nothing. `Settings` may be const.
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
  // A tissue's values for a model are in the element of the model's name; all models of a deformable body share one.
  const bool has_body = anatomy::body_of(settings.haptics.resistance) != nullptr;
  const std::string_view asked = has_body ? "deformable" : anatomy::name_of(settings.haptics.resistance);
  for_each_inside(
      [&](const auto& element, auto& value) {
        if (element.name == asked) visit(value);
      },
      *found);
}

}  // namespace bodkin::forces
