#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/settings_check.h"

namespace bodkin {

// Settings as text, between a struct with a parameter table and a file or a command line. Texts are lossless: a
// struct that is converted to a tree and read back has the same bits.
struct SettingsTree {
  std::string name;  // of a model or an element: "tracking_wall"
  std::vector<std::pair<std::string, std::string>> values;
  std::vector<SettingsTree> children;
  int line = 0;  // of the file from which it was read; 0: none

  // nullptr when the value is not stated.
  const std::string* find(std::string_view value) const noexcept;
  // "FILE, line 12: NAME", or "FILE: NAME" without a line.
  std::string origin(std::string_view file) const;

  bool operator==(const SettingsTree& other) const {
    return name == other.name && values == other.values && children == other.children;
  }
};

// "NAME SETTING=VALUE SETTING=VALUE; CHILD SETTING=VALUE": as people type it.
std::string tree_text(const SettingsTree& tree);

// All parameters of the settings, including those with their defaults.
template <Parameterized Settings>
SettingsTree settings_tree(std::string name, const Settings& settings) {
  SettingsTree tree{.name = std::move(name)};
  const std::string_view word = alternative_of(settings);
  SettingsTree* place = &tree;
  if (!word.empty()) {
    tree.children.push_back({.name = std::string(word)});
    place = &tree.children.back();
  }
  for_each_parameter(
      [&](const auto& parameter, const auto& value) {
        if (counts_for(parameter, word)) place->values.emplace_back(parameter.name, value_text(value));
      },
      settings);
  const Settings defaults{};
  for_each_inside(
      [&](const auto& entry, const auto& value, const auto& by_default) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>) {
          for (const auto& item : value) place->children.push_back(settings_tree(std::string(entry.name), item));
        } else if constexpr (parameter_detail::is_optional<Value>) {
          if (value) place->children.push_back(settings_tree(std::string(entry.name), *value));
        } else {
          (void)by_default;
          place->children.push_back(settings_tree(std::string(entry.name), value));
        }
      },
      settings, defaults);
  return tree;
}

namespace settings_detail {

// Throws InputError: the settings have no parameter of this name.
[[noreturn]] void refuse_unknown(const SettingsTree& tree, std::string_view file, const std::string& what,
                                 const std::string& known);

// The value that a tree states for a parameter, under its name or an earlier one; nullptr: none.
template <typename Settings>
const std::string* stated_value(const SettingsTree& tree, std::string_view parameter) {
  if (const std::string* text = tree.find(parameter); text != nullptr) return text;
  for (const EarlierName& earlier : earlier_names_of<Settings>()) {
    if (earlier.now != parameter) continue;
    if (const std::string* text = tree.find(earlier.name); text != nullptr) return text;
  }
  return nullptr;
}

template <typename Settings>
void read_values(Settings& settings, const SettingsTree& tree, std::string_view file, std::string_view word) {
  std::string known;
  std::size_t found = 0;
  int joint = 0, joint_found = 0;
  for_each_parameter(
      [&](const auto& parameter, auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if (!counts_for(parameter, word)) return;
        known += (known.empty() ? "" : ", ") + std::string(parameter.name);
        joint += parameter.is_joint ? 1 : 0;
        const std::string* text = stated_value<Settings>(tree, parameter.name);
        if (text == nullptr) return;
        ++found;
        joint_found += parameter.is_joint ? 1 : 0;
        if (!parse_value(*text, value)) {
          refuse_setting(tree.origin(file), std::string(parameter.name) + " is '" + text->substr(0, 60) +
                                                "', expected " + type_words<Value>());
        }
      },
      settings);
  if (joint_found != 0 && joint_found != joint) {
    refuse_setting(tree.origin(file), std::to_string(joint_found) + " of the " + std::to_string(joint) +
                                          " components of a vector are given, expected all or none");
  }
  if (found == tree.values.size()) return;
  for (const auto& value : tree.values) {
    bool is_known = false;
    for (const EarlierName& earlier : earlier_names_of<Settings>())
      is_known = is_known || earlier.name == value.first;
    for_each_parameter(
        [&](const auto& parameter, const auto&) {
          is_known = is_known || (counts_for(parameter, word) && parameter.name == value.first);
        },
        settings);
    if (!is_known) refuse_unknown(tree, file, "the unknown setting " + value.first, known);
  }
}

}  // namespace settings_detail

// Reads the stated values and leaves the rest of `settings` unchanged. `file` names the tree in messages. Throws
// InputError for an unknown name and for a value of another type; check() tests the ranges.
template <Parameterized Settings>
void read_settings(Settings& settings, const SettingsTree& tree, std::string_view file) {
  const SettingsTree* place = &tree;
  for_each_entry(
      [&](const auto& entry, auto& value) {
        if constexpr (parameter_detail::is_alternatives<std::remove_cvref_t<decltype(entry)>>) {
          if (tree.children.size() != 1 || !parse_value(tree.children.front().name, value)) {
            refuse_setting(tree.origin(file),
                           "expected one element inside: " + type_words<std::remove_cvref_t<decltype(value)>>());
          }
          place = &tree.children.front();
        }
      },
      settings);
  settings_detail::read_values(settings, *place, file, alternative_of(settings));
  std::string known;
  std::size_t found = 0;
  for_each_inside(
      [&](const auto& entry, auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        known += (known.empty() ? "" : ", ") + std::string(entry.name);
        std::size_t times = 0;
        for (const SettingsTree& child : place->children) {
          if (child.name != entry.name) continue;
          ++times;
          if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>) {
            value.emplace_back();
            read_settings(value.back(), child, file);
          } else if constexpr (parameter_detail::is_optional<Value>) {
            value.emplace();
            read_settings(*value, child, file);
          } else {
            read_settings(value, child, file);
          }
        }
        if (!parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>> && times > 1) {
          refuse_setting(tree.origin(file), "the element " + std::string(entry.name) + " is given " +
                                                std::to_string(times) + " times, expected it once at most");
        }
        found += times;
      },
      settings);
  if (found == place->children.size()) return;
  for (const SettingsTree& child : place->children) {
    bool is_known = false;
    for_each_inside([&](const auto& entry, const auto&) { is_known = is_known || entry.name == child.name; },
                    settings);
    if (!is_known) settings_detail::refuse_unknown(*place, file, "the unknown element " + child.name, known);
  }
}

// The settings stated by a tree, checked; all others have their defaults.
template <Parameterized Settings>
Settings settings_from(const SettingsTree& tree, std::string_view file) {
  Settings settings;
  read_settings(settings, tree, file);
  // The values of an alternative stand in the element inside.
  check(settings, (alternative_of(settings).empty() ? tree : tree.children.front()).origin(file));
  return settings;
}

}  // namespace bodkin
