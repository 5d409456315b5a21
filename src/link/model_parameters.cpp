#include "link/model_parameters.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/settings_check.h"

namespace bodkin::link {

namespace {

using forces::ModelPart;
using forces::ModelSettings;

struct Part {
  ModelPart kind = ModelPart::resistance;
  anatomy::TissueId tissue = anatomy::tissue::air;
};

constexpr std::array<std::pair<std::string_view, ModelPart>, 3> own_parts = {{{"resistance", ModelPart::resistance},
                                                                              {"constraint", ModelPart::constraint},
                                                                              {"compensation", ModelPart::weight}}};

// Calls visit(parameter, value, struct) for each parameter that a client may set: not for vectors, whose components
// are given together or not at all.
template <typename Settings, typename Visit>
void visit_parameters(Settings& settings, const Part& part, const Visit& visit) {
  forces::visit_part(settings, part.kind, part.tissue, [&](auto& owner) {
    const std::string_view word = alternative_of(owner);
    for_each_parameter(
        [&](const auto& parameter, auto& value) {
          if (counts_for(parameter, word) && !parameter.is_joint) visit(parameter, value, owner);
        },
        owner);
  });
}

std::vector<std::string> names_of_parts(const ModelSettings& settings) {
  std::vector<std::string> names;
  for (const auto& [name, kind] : own_parts) names.emplace_back(name);
  for (const anatomy::TissueProperties& tissue : settings.tissues) {
    bool has_any = false;
    visit_parameters(settings, {ModelPart::tissue, tissue.id},
                     [&](const auto&, const auto&, const auto&) { has_any = true; });
    if (has_any) names.push_back(tissue.name);
  }
  return names;
}

Part part_called(const ModelSettings& settings, const std::string& name) {
  for (const auto& [known, kind] : own_parts) {
    if (known == name) return {kind, anatomy::tissue::air};
  }
  for (const anatomy::TissueProperties& tissue : settings.tissues) {
    if (tissue.name == name) return {ModelPart::tissue, tissue.id};
  }
  throw InputError(
      fmt::format("Part is '{}', expected one of {}", name.substr(0, 40), fmt::join(names_of_parts(settings), ", ")));
}

}  // namespace

std::string parameters_json(const ModelSettings& settings, const std::string& part) {
  nlohmann::ordered_json json;
  json["model"] = anatomy::name_of(settings.haptics.resistance);
  json["part"] = part;
  json["parts"] = names_of_parts(settings);
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  visit_parameters(settings, part_called(settings, part), [&](const auto& parameter, const auto& value, const auto&) {
    using Value = std::remove_cvref_t<decltype(value)>;
    nlohmann::ordered_json one;
    one["name"] = parameter.name;
    if constexpr (std::is_arithmetic_v<Value> && !std::same_as<Value, bool>) {
      one["value"] = value;
      one["unit"] = parameter.unit;
      if (std::isfinite(parameter.range.low)) one["low"] = parameter.range.low;
      if (std::isfinite(parameter.range.high)) one["high"] = parameter.range.high;
    } else {
      one["value"] = value_text(value);
      one["choices"] = type_words<Value>();
    }
    one["description"] = parameter.description;
    one["origin"] = value_text(parameter.origin);
    all.push_back(std::move(one));
  });
  json["parameters"] = std::move(all);
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void set_parameter(ModelSettings& settings, const std::string& part, const std::string& name,
                   const std::string& text) {
  const Part wanted = part_called(settings, part);
  ModelSettings changed = settings;
  bool is_known = false;
  std::string known;
  visit_parameters(changed, wanted, [&](const auto& parameter, auto& value, const auto&) {
    known += (known.empty() ? "" : ", ") + std::string(parameter.name);
    if (parameter.name != name) return;
    is_known = true;
    if (!parse_value(text, value)) {
      throw InputError(fmt::format("{} of {} is '{}', expected {}", name, part, text.substr(0, 40),
                                   type_words<std::remove_cvref_t<decltype(value)>>()));
    }
  });
  if (!is_known) {
    throw InputError(fmt::format("{} has no parameter '{}' for {}, expected {}", part, name.substr(0, 40),
                                 anatomy::name_of(settings.haptics.resistance),
                                 known.empty() ? "another part: it has none" : "one of " + known));
  }
  forces::visit_part(std::as_const(changed), wanted.kind, wanted.tissue,
                     [&](const auto& owner) { check(owner, part); });
  settings = std::move(changed);
}

std::string set_parameter(ModelSettings& settings, const Command& command) {
  const auto value = [&command](const char* key) {
    const auto found = command.values.find(key);
    if (found == command.values.end())
      throw InputError(fmt::format("the command {} needs {}=\"...\"", command.name, key));
    return found->second;
  };
  const std::string part = value("Part"), name = value("Parameter"), text = value("Value");
  set_parameter(settings, part, name, text);
  return fmt::format("{} of {} is {}", name, part, text);
}

}  // namespace bodkin::link
