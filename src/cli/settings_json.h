#pragma once

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "anatomy/registered_settings.h"
#include "core/settings_tree.h"

namespace bodkin::cli {

// A value as JSON: what is a number or a truth value there stays one; infinity is "INF", as in files.
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

// All parameters of settings under the names that their table gives them, with their units in the names as in files;
// settings inside are objects, elements of which there may be several are arrays of objects.
template <Parameterized Settings>
nlohmann::json settings_json(const Settings& settings) {
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
          for (const auto& item : value) inside.push_back(settings_json(item));
        } else if constexpr (parameter_detail::is_optional<Value>) {
          if (value) inside = settings_json(*value);
        } else {
          inside = settings_json(value);
        }
      },
      settings, defaults);
  return result;
}

// Of a model that another program registered: the values are texts, as its settings are not known here.
inline nlohmann::json settings_json(const anatomy::RegisteredSettings& settings) {
  nlohmann::json result = nlohmann::json::object();
  for (const auto& [name, value] : settings.values) result[name] = value;
  return result;
}

}  // namespace bodkin::cli
