#pragma once

#include <cmath>
#include <string>

#include "core/parameter.h"

namespace bodkin {

// Changes one parameter of the settings minimally, the `which`-th of all nested ones; counts `which` down on the way.
// Returns its name, or nothing if there are fewer.
template <Parameterized Settings>
std::string change_parameter(Settings& settings, int& which) {
  std::string changed;
  for_each_entry(
      [&](const auto& entry, auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if (which < 0) return;
        if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>) {
          if (which-- == 0) {
            value.emplace_back();
            changed = entry.name;
          }
          return;
        } else if constexpr (parameter_detail::is_optional<Value>) {
          if (which-- != 0) return;
          value = value ? std::nullopt : Value(std::in_place);
          changed = entry.name;
        } else if constexpr (Parameterized<Value>) {
          changed = change_parameter(value, which);
          if (!changed.empty()) changed = std::string(entry.name) + " " + changed;
        } else {
          if (which-- != 0) return;
          if constexpr (std::same_as<Value, bool>) {
            value = !value;
          } else if constexpr (NamedEnumeration<Value>) {
            value = static_cast<Value>((static_cast<std::size_t>(value) + 1) % enumeration_names(value).size());
          } else if constexpr (std::floating_point<Value>) {
            value = std::nextafter(value, value < 1.0 ? unbounded : 0.0);
          } else if constexpr (WholeNumber<Value>) {
            value = static_cast<Value>(value + 1);
          } else {
            value += "x";
          }
          if constexpr (parameter_detail::is_leaf<std::remove_cvref_t<decltype(entry)>>) {
            changed = entry.name;
          } else {
            changed = "kind";
          }
        }
      },
      settings);
  return changed;
}

}  // namespace bodkin
