#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/geometry.h"
#include "core/parameter_value.h"

namespace bodkin {

// One declaration per parameter. A settings struct states its defaults in its member initialisers and everything else
// in a table next to them:
//
//   struct SpringSettings {
//     double stiffness = 0.5;
//     bool rigid = false;
//
//     template <typename S = SpringSettings>  // a template costs nothing where the table is not used
//     static constexpr auto parameters() {
//       return std::tuple{
//           Parameter{"stiffness_N_per_mm", &S::stiffness, Range{0.0, 100.0}, "N/mm", "of the wall", Origin::paper},
//           Parameter{"rigid", &S::rigid, "the wall does not give way", Origin::choice}};
//     }
//     template <typename S = SpringSettings>
//     static constexpr auto relations() {  // optional
//       return std::tuple{AtMost{&S::low, &S::high}};
//     }
//   };
//
// Files, command lines, range checks, schemas, pages and digests are derived from that table (settings_check.h,
// settings_tree.h).

// Where a default comes from.
enum class Origin : std::uint8_t {
  paper,       // printed in the paper of the model
  literature,  // printed elsewhere
  choice       // chosen by this project
};
constexpr std::array<std::string_view, 3> enumeration_names(Origin) {
  return {"paper", "literature", "our choice"};
}

// One number, Boolean, word of an enumeration or text.
template <typename Owner, typename Value>
struct Parameter {
  using value_type = Value;

  std::string_view name;  // as files and command lines write it; ends with the unit: "stiffness_N_per_mm"
  Value Owner::*member;
  Range range = any_number;
  std::string_view unit;         // "N/mm"; empty: none
  std::string_view description;  // a phrase
  Origin origin = Origin::choice;
  bool is_joint = false;         // a file states all joint parameters of a struct or none
  std::string_view alternative;  // the word of the struct's Alternatives for which it applies; empty: all

  constexpr Parameter(std::string_view its_name, Value Owner::*its_member, Range its_range, std::string_view its_unit,
                      std::string_view its_description, Origin its_origin)
      : name(its_name),
        member(its_member),
        range(its_range),
        unit(its_unit),
        description(its_description),
        origin(its_origin) {}
  constexpr Parameter(std::string_view its_name, Value Owner::*its_member, std::string_view its_description,
                      Origin its_origin)
      : name(its_name), member(its_member), description(its_description), origin(its_origin) {}

  constexpr Parameter only_of(std::string_view word) const {
    Parameter changed = *this;
    changed.alternative = word;
    return changed;
  }

  template <typename Settings>
  constexpr auto& of(Settings& settings) const {
    return settings.*member;
  }
};

// One coordinate of a vector.
template <typename Owner>
struct Component {
  using value_type = double;

  std::string_view name;
  Vec3 Owner::*member;
  int axis;
  Range range;
  std::string_view unit;
  std::string_view description;
  Origin origin;
  bool is_joint = false;
  std::string_view alternative;

  constexpr Component(std::string_view its_name, Vec3 Owner::*its_member, int its_axis, Range its_range,
                      std::string_view its_unit, std::string_view its_description, Origin its_origin)
      : name(its_name),
        member(its_member),
        axis(its_axis),
        range(its_range),
        unit(its_unit),
        description(its_description),
        origin(its_origin) {}

  constexpr Component joint() const {
    Component changed = *this;
    changed.is_joint = true;
    return changed;
  }

  template <typename Settings>
  auto& of(Settings& settings) const {
    return (settings.*member)[axis];
  }
};

// A parameter's name in earlier versions, which files may still state. `now`: its present name; empty: the parameter
// no longer exists and its value is ignored. A struct with earlier names returns an array of them from
// earlier_names().
struct EarlierName {
  std::string_view name;
  std::string_view now = {};
};

// The parameters of a member, treated as the struct's own.
template <typename Owner, typename Value>
struct Inlined {
  Value Owner::*member;
};

// An enumeration that files write as the name of the one child element: <layered><viscous drag="..."/></layered>. It
// is the first entry of a table; parameters with only_of() are attributes of that element.
template <typename Owner, typename Value>
struct Alternatives {
  Value Owner::*member;
  std::string_view description;
};

// A member that files write as an optional child element. Without the element a std::optional is empty, and any other
// member keeps its default.
template <typename Owner, typename Value>
struct ChildElement {
  std::string_view name;
  Value Owner::*member;
  std::string_view description;
};

// A list of child elements, in the order of the file.
template <typename Owner, typename Value>
struct ChildElements {
  std::string_view name;
  std::vector<Value> Owner::*member;
  std::string_view description;
  std::size_t most;
};

template <typename Owner, typename Value>
Inlined(Value Owner::*) -> Inlined<Owner, Value>;
template <typename Owner, typename Value>
Alternatives(Value Owner::*, std::string_view) -> Alternatives<Owner, Value>;
template <typename Owner, typename Value>
ChildElement(std::string_view, Value Owner::*, std::string_view) -> ChildElement<Owner, Value>;
template <typename Owner, typename Value>
ChildElements(std::string_view, std::vector<Value> Owner::*, std::string_view, std::size_t)
    -> ChildElements<Owner, Value>;

// A struct with a parameter table.
template <typename Settings>
concept Parameterized = requires {
  std::remove_cvref_t<Settings>::parameters();
};

// Calls visit(item) for each item of a tuple. std::apply() does too, but takes a tenth of a module's compile time.
template <typename... Items, typename Visit>
constexpr void for_each_item(const std::tuple<Items...>& tuple, const Visit& visit) {
  [&]<std::size_t... index>(std::index_sequence<index...>) {
    (visit(std::get<index>(tuple)), ...);
  }
  (std::index_sequence_for<Items...>());
}

namespace parameter_detail {

template <typename Entry>
inline constexpr bool is_leaf = requires {
  typename Entry::value_type;
};

template <typename>
inline constexpr bool is_inlined = false;
template <typename Owner, typename Value>
inline constexpr bool is_inlined<Inlined<Owner, Value>> = true;

template <typename>
inline constexpr bool is_alternatives = false;
template <typename Owner, typename Value>
inline constexpr bool is_alternatives<Alternatives<Owner, Value>> = true;

template <typename>
inline constexpr bool is_optional = false;
template <typename Value>
inline constexpr bool is_optional<std::optional<Value>> = true;

template <typename>
inline constexpr bool is_list = false;
template <typename Owner, typename Value>
inline constexpr bool is_list<ChildElements<Owner, Value>> = true;

}  // namespace parameter_detail

// The earlier names of the struct's parameters.
template <Parameterized Settings>
constexpr auto earlier_names_of() {
  if constexpr (requires { Settings::earlier_names(); })
    return Settings::earlier_names();
  else
    return std::array<EarlierName, 0>();
}

// Calls visit(entry, values...) for each entry of the table, including those of groups; `values` are the entry's
// members in the given structs, which all have one type. Entries are Parameter, Component, Alternatives, ChildElement
// or ChildElements.
template <typename Visit, typename First, typename... More>
constexpr void for_each_entry(Visit&& visit, First&& first, More&&... more) {
  const auto one = [&](const auto& entry) {
    using Entry = std::remove_cvref_t<decltype(entry)>;
    if constexpr (parameter_detail::is_inlined<Entry>) {
      for_each_entry(visit, first.*entry.member, more.*entry.member...);
    } else if constexpr (parameter_detail::is_leaf<Entry>) {
      visit(entry, entry.of(first), entry.of(more)...);
    } else {
      visit(entry, first.*entry.member, more.*entry.member...);
    }
  };
  for_each_item(std::remove_cvref_t<First>::parameters(), one);
}

// As above, only for the struct's own parameters: numbers, Booleans, words and texts.
template <typename Visit, typename First, typename... More>
constexpr void for_each_parameter(Visit&& visit, First&& first, More&&... more) {
  for_each_entry(
      [&](const auto& entry, auto&... values) {
        if constexpr (parameter_detail::is_leaf<std::remove_cvref_t<decltype(entry)>>) visit(entry, values...);
      },
      first, more...);
}

// As above, only for child elements: ChildElement and ChildElements.
template <typename Visit, typename First, typename... More>
constexpr void for_each_inside(Visit&& visit, First&& first, More&&... more) {
  for_each_entry(
      [&](const auto& entry, auto&... values) {
        using Entry = std::remove_cvref_t<decltype(entry)>;
        if constexpr (!parameter_detail::is_leaf<Entry> && !parameter_detail::is_alternatives<Entry>)
          visit(entry, values...);
      },
      first, more...);
}

// The word of the struct's Alternatives; empty for a struct without them.
template <Parameterized Settings>
std::string_view alternative_of(const Settings& settings) {
  std::string_view word;
  for_each_entry(
      [&](const auto& entry, const auto& value) {
        if constexpr (parameter_detail::is_alternatives<std::remove_cvref_t<decltype(entry)>>)
          word = enumeration_names(value)[static_cast<std::size_t>(value)];
      },
      settings);
  return word;
}

// Whether a parameter applies in a struct whose alternative is `word`.
constexpr bool counts_for(const auto& parameter, std::string_view word) {
  return parameter.alternative.empty() || parameter.alternative == word;
}

}  // namespace bodkin
