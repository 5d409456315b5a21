#include "core/settings_tree.h"

#include <algorithm>

namespace bodkin {

const std::string* SettingsTree::find(std::string_view value) const noexcept {
  const auto found =
      std::find_if(values.begin(), values.end(), [value](const auto& entry) { return entry.first == value; });
  return found == values.end() ? nullptr : &found->second;
}

std::string SettingsTree::origin(std::string_view file) const {
  return std::string(file) + (line == 0 ? "" : ", line " + std::to_string(line)) + ": " + name;
}

std::string tree_text(const SettingsTree& tree) {
  std::string text = tree.name;
  for (const auto& [name, value] : tree.values) text += " " + name + "=" + value;
  for (const SettingsTree& child : tree.children) text += "; " + tree_text(child);
  return text;
}

void settings_detail::refuse_unknown(const SettingsTree& tree, std::string_view file, const std::string& what,
                                     const std::string& known) {
  refuse_setting(tree.origin(file), "has " + what + "; it takes " + (known.empty() ? "none" : known));
}

}  // namespace bodkin
