#pragma once

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/settings_tree.h"

namespace bodkin::anatomy {

// The choice of a resistance that the program registers itself (simulation/resistance_models.h): its name, and its
// settings as texts, which the model's own table of parameters reads when the case is simulated.
struct RegisteredSettings {
  std::string name;
  std::vector<std::pair<std::string, std::string>> values;
  std::vector<SettingsTree> children;

  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &RegisteredSettings::name, "of the model that the program registered", Origin::choice}};
  }
};

// From an element whose attribute `name` is the model's.
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

// The inverse.
inline SettingsTree settings_tree(std::string name, const RegisteredSettings& chosen) {
  SettingsTree tree{.name = std::move(name), .values = {{"name", chosen.name}}, .children = chosen.children};
  tree.values.insert(tree.values.end(), chosen.values.begin(), chosen.values.end());
  return tree;
}

}  // namespace bodkin::anatomy
