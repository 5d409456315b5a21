#pragma once

#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/settings_tree.h"

namespace bodkin::anatomy {

// The choice of a resistance that the program itself registers (simulation/resistance_models.h): its name, and its
// settings as text, which the model's own parameter table reads when the case is simulated.
struct RegisteredSettings {
  static constexpr std::string_view element = "registered";
  std::string name;
  std::vector<std::pair<std::string, std::string>> values;
  std::vector<SettingsTree> children;

  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &RegisteredSettings::name, "of the model that the program registered", Origin::choice}};
  }
};

// Reads an element in which the attribute `name` is the model's.
inline RegisteredSettings registered_from(const SettingsTree& tree) {
  RegisteredSettings chosen;
  chosen.children = tree.children;
  for (const auto& [name, value] : tree.values) {
    if (name == "name") {
      chosen.name = value;
    } else {
      chosen.values.emplace_back(name, value);
    }
  }
  return chosen;
}

// The inverse of registered_from().
inline SettingsTree settings_tree(std::string name, const RegisteredSettings& chosen) {
  SettingsTree tree{.name = std::move(name), .values = {{"name", chosen.name}}, .children = chosen.children};
  tree.values.insert(tree.values.end(), chosen.values.begin(), chosen.values.end());
  return tree;
}

}  // namespace bodkin::anatomy
