#include "cli/settings_json.h"

#include <cmath>
#include <concepts>
#include <string>
#include <variant>

#include <nlohmann/json.hpp>

#include "core/settings_tree.h"

namespace bodkin::cli {

namespace {

// A value as JSON: numbers and truth values stay such; infinity is "INF", as in files.
template <typename Value>
nlohmann::json value_json(const Value& value) {
  if constexpr (std::floating_point<Value>) {
    if (!std::isfinite(value)) return value_text(value);
    return value;
  } else if constexpr (std::same_as<Value, bool> || WholeNumber<Value>) {
    return value;
  } else {
    return value_text(value);
  }
}

// All parameters of settings under their table names, which include units, as in files; nested settings are objects,
// repeatable elements are arrays of objects.
template <Parameterized Settings>
nlohmann::json json_of(const Settings& settings) {
  nlohmann::json result = nlohmann::json::object();
  const std::string_view word = alternative_of(settings);
  nlohmann::json& place = word.empty() ? result : result[std::string(word)] = nlohmann::json::object();
  for_each_parameter(
      [&](const auto& parameter, const auto& value) {
        if (counts_for(parameter, word)) place[std::string(parameter.name)] = value_json(value);
      },
      settings);
  const Settings defaults{};
  for_each_inside(
      [&](const auto& entry, const auto& value, const auto&) {
        using Value = std::remove_cvref_t<decltype(value)>;
        nlohmann::json& inside = place[std::string(entry.name)];
        if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>) {
          inside = nlohmann::json::array();
          for (const auto& item : value) inside.push_back(json_of(item));
        } else if constexpr (parameter_detail::is_optional<Value>) {
          if (value) inside = json_of(*value);
        } else {
          inside = json_of(value);
        }
      },
      settings, defaults);
  return result;
}

// For a model registered by another program: the values are texts, because its settings are not known here.
nlohmann::json json_of(const anatomy::RegisteredSettings& settings) {
  nlohmann::json result = nlohmann::json::object();
  for (const auto& [name, value] : settings.values) result[name] = value;
  return result;
}

template <typename Models>
nlohmann::json json_of_model(const Models& models) {
  return std::visit([](const auto& settings) { return json_of(settings); }, models);
}

}  // namespace

nlohmann::json settings_json(const anatomy::Needle& needle) {
  return json_of(needle);
}
nlohmann::json settings_json(const anatomy::DeviceLimits& device) {
  return json_of(device);
}
nlohmann::json settings_json(const anatomy::TissueProperties& tissue) {
  return json_of(tissue);
}
nlohmann::json settings_json(const anatomy::ResistanceSettings& resistance) {
  return json_of_model(resistance);
}
nlohmann::json settings_json(const anatomy::ConstraintSettings& constraint) {
  return json_of_model(constraint);
}

}  // namespace bodkin::cli
