#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "core/parameter.h"

namespace bodkin {

// Throws InputError "ORIGIN: SENTENCE".
[[noreturn]] void refuse_setting(std::string_view origin, std::string_view sentence);

// Throws InputError "ORIGIN: NAME is VALUE UNIT, expected LOW to HIGH UNIT" unless the range contains the value. NaN
// is in no range.
inline void check_range(std::string_view origin, std::string_view name, double value, const Range& range,
                        std::string_view unit) {
  if (range.contains(value)) return;
  std::string sentence(name);
  sentence += " is " + number_words(value);
  if (!unit.empty()) sentence.append(" ").append(unit);
  refuse_setting(origin, sentence + ", expected " + range_words(range, unit));
}

// Throws InputError unless `dt` is a usable tick, 1e-6 to 0.1 s.
void check_tick(std::string_view origin, double dt);

// The table's declaration of the parameter that `member` is.
struct DeclaredParameter {
  std::string_view name;
  std::string_view unit;
  Range range;
};
template <typename Settings>
DeclaredParameter declaration_of_member(const Settings& settings, const void* member) {
  DeclaredParameter found;
  for_each_parameter(
      [&](const auto& parameter, const auto& value) {
        if (static_cast<const void*>(&value) == member) found = {parameter.name, parameter.unit, parameter.range};
      },
      settings);
  return found;
}
template <Parameterized Settings, typename Value>
DeclaredParameter declaration_of(Value Settings::*member) {
  const Settings defaults{};
  return declaration_of_member(defaults, &(defaults.*member));
}

// One parameter is at most (minus `margin`) another parameter of the same unit.
template <typename Owner>
struct AtMost {
  double Owner::*lower;
  double Owner::*upper;
  double margin = 0.0;
  std::string_view alternative;  // the one for which the relation applies; empty: all

  constexpr AtMost(double Owner::*its_lower, double Owner::*its_upper, double its_margin = 0.0,
                   std::string_view its_alternative = {})
      : lower(its_lower), upper(its_upper), margin(its_margin), alternative(its_alternative) {}

  void check(const Owner& settings, std::string_view origin) const {
    if (!alternative.empty() && alternative_of(settings) != alternative) return;
    if (settings.*lower <= settings.*upper - margin) return;
    const DeclaredParameter low = declaration_of_member(settings, &(settings.*lower));
    const DeclaredParameter high = declaration_of_member(settings, &(settings.*upper));
    const std::string unit = low.unit.empty() ? "" : " " + std::string(low.unit);
    const std::string less = margin == 0.0 ? "" : ", less " + number_words(margin) + unit;
    refuse_setting(origin, std::string(low.name) + " is " + number_words(settings.*lower) + unit +
                               ", expected at most the " + std::string(high.name) + " of " +
                               number_words(settings.*upper) +
                               (high.unit.empty() ? "" : " " + std::string(high.unit)) + less);
  }
};

// The elements of a list are in ascending order of one parameter. `first`: required value of the first, NaN: any.
template <typename Owner, typename Item>
struct Rising {
  std::vector<Item> Owner::*list;
  double Item::*key;
  double first;

  constexpr Rising(std::vector<Item> Owner::*its_list, double Item::*its_key, double its_first)
      : list(its_list), key(its_key), first(its_first) {}

  void check(const Owner& settings, std::string_view origin) const {
    const std::vector<Item>& items = settings.*list;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const double value = items[i].*key;
      const std::string found = std::string(declaration_of_member(items[i], &(items[i].*key)).name) + " of element " +
                                std::to_string(i + 1) + " is " + number_words(value);
      if (i == 0 && !std::isnan(first) && value != first)
        refuse_setting(origin, found + ", expected " + number_words(first) + " for the first one");
      if (i > 0 && !(value > items[i - 1].*key))
        refuse_setting(origin,
                       found + ", expected more than the " + number_words(items[i - 1].*key) + " of the one before");
    }
  }
};

// Any other condition. `sentence` says what is found and what is expected.
template <typename Owner>
struct Relation {
  bool (*holds)(const Owner&);
  std::string_view sentence;

  constexpr Relation(bool (*it_holds)(const Owner&), std::string_view its_sentence)
      : holds(it_holds), sentence(its_sentence) {}

  void check(const Owner& settings, std::string_view origin) const {
    if (!holds(settings)) refuse_setting(origin, sentence);
  }
};

// Whether two structs of one type have equal parameters throughout.
template <typename Settings>
bool same_parameters(const Settings& one, const Settings& other);

// Throws InputError for the first relation that does not hold, including those of inlined structs.
template <Parameterized Settings>
void check_relations(const Settings& settings, std::string_view origin) {
  if constexpr (requires { Settings::relations(); }) {
    for_each_item(Settings::relations(), [&](const auto& relation) { relation.check(settings, origin); });
  }
  const auto inlined = [&](const auto& entry) {
    if constexpr (parameter_detail::is_inlined<std::remove_cvref_t<decltype(entry)>>)
      check_relations(settings.*entry.member, origin);
  };
  for_each_item(Settings::parameters(), inlined);
}

// Throws InputError for the first parameter out of its range and for the first relation that does not hold, including
// those of child elements: "ORIGIN: cutting_force_N is 9 N, expected at most the puncture_force_N of 1 N". A child
// whose parameters all have their defaults counts as missing and is not checked. unwritten() is a table like
// parameters(), of the parameters that files do not write here because they state them elsewhere.
template <Parameterized Settings>
void check(const Settings& settings, std::string_view origin) {
  const std::string_view word = alternative_of(settings);
  for_each_parameter(
      [&](const auto& parameter, const auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_arithmetic_v<Value> && !std::same_as<Value, bool>) {
          if (counts_for(parameter, word))
            check_range(origin, parameter.name, static_cast<double>(value), parameter.range, parameter.unit);
        }
      },
      settings);
  if constexpr (requires { Settings::unwritten(); }) {
    for_each_item(Settings::unwritten(), [&](const auto& parameter) {
      check_range(origin, parameter.name, parameter.of(settings), parameter.range, parameter.unit);
    });
  }
  check_relations(settings, origin);
  const Settings defaults{};
  for_each_inside(
      [&](const auto& entry, const auto& value, const auto& by_default) {
        using Value = std::remove_cvref_t<decltype(value)>;
        const std::string inside = std::string(origin) + ", " + std::string(entry.name);
        if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>) {
          if (value.size() > entry.most) {
            refuse_setting(origin, "there are " + std::to_string(value.size()) + " elements " +
                                       std::string(entry.name) + ", expected at most " + std::to_string(entry.most));
          }
          for (const auto& item : value) check(item, inside);
        } else if constexpr (parameter_detail::is_optional<Value>) {
          if (value) check(*value, inside);
        } else {
          if (!same_parameters(value, by_default)) check(value, inside);
        }
      },
      settings, defaults);
}

template <typename Settings>
bool same_parameters(const Settings& one, const Settings& other) {
  bool same = true;
  for_each_entry(
      [&](const auto& entry, const auto& mine, const auto& yours) {
        using Value = std::remove_cvref_t<decltype(mine)>;
        if constexpr (parameter_detail::is_list<std::remove_cvref_t<decltype(entry)>>) {
          same = same && mine.size() == yours.size();
          for (std::size_t i = 0; same && i < mine.size(); ++i) same = same_parameters(mine[i], yours[i]);
        } else if constexpr (parameter_detail::is_optional<Value>) {
          same = same && mine.has_value() == yours.has_value() && (!mine || same_parameters(*mine, *yours));
        } else if constexpr (Parameterized<Value>) {
          same = same && same_parameters(mine, yours);
        } else {
          same = same && mine == yours;
        }
      },
      one, other);
  return same;
}

}  // namespace bodkin
