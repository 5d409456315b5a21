#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace bodkin {

// The range of values that a parameter may have.
struct Range {
  double low = 0.0;
  double high = 0.0;
  bool includes_low = true;
  bool includes_high = true;

  // False for NaN.
  constexpr bool contains(double value) const {
    return (includes_low ? value >= low : value > low) && (includes_high ? value <= high : value < high);
  }
};

inline constexpr double unbounded = std::numeric_limits<double>::infinity();
inline constexpr Range any_number = {-unbounded, unbounded, false, false};

// A range without its lower bound.
constexpr Range above(double low, double high) {
  return {low, high, false, true};
}
// A range without its upper bound.
constexpr Range from_to_below(double low, double high) {
  return {low, high, true, false};
}

// An enumeration whose words files use: enumeration_names(Enum) lists them in the order of the values, which begin at
// 0 and have no gaps.
template <typename Value>
concept NamedEnumeration = std::is_enum_v<Value> && requires(Value value) {
  enumeration_names(value);
};

template <typename Value>
concept WholeNumber = std::integral<Value> && !std::same_as<Value, bool>;

// The shortest text that reads back to the same bits; infinity is "INF", as in XML.
std::string number_text(double value);

// As number_text(), for people: infinity is "infinity".
std::string number_words(double value);

// "0 to 100 N/mm", "more than 0 and at most 100 N", "0.001 s to infinity".
std::string range_words(const Range& range, std::string_view unit);

// Reads "-1.5", "+2", "1e-3", "INF"; blanks around are allowed. False for anything else and NaN.
bool parse_number(std::string_view text, double& value);

std::string_view without_blanks(std::string_view text);

// The name of a parameter without its unit suffix: "stiffness_N_per_mm" in "N/mm" becomes "stiffness",
// "curvature_per_mm" in "1/mm" becomes "curvature".
std::string_view name_without_unit(std::string_view name, std::string_view unit);

// A value as files and command lines write it.
template <typename Value>
std::string value_text(const Value& value) {
  if constexpr (std::same_as<Value, bool>) {
    return value ? "true" : "false";
  } else if constexpr (NamedEnumeration<Value>) {
    return std::string(enumeration_names(value)[static_cast<std::size_t>(value)]);
  } else if constexpr (WholeNumber<Value>) {
    return std::to_string(value);
  } else if constexpr (std::floating_point<Value>) {
    return number_text(value);
  } else {
    return std::string(value);
  }
}

// The inverse of value_text(). Returns false and leaves `value` unchanged when the text is not such a value.
template <typename Value>
bool parse_value(std::string_view text, Value& value) {
  if constexpr (std::floating_point<Value>) {
    return parse_number(text, value);
  } else if constexpr (std::same_as<Value, std::string>) {
    value = text;
    return true;
  } else {
    text = without_blanks(text);
    if constexpr (std::same_as<Value, bool>) {
      const bool yes = text == "true" || text == "1";
      if (!yes && text != "false" && text != "0") return false;
      value = yes;
      return true;
    } else if constexpr (NamedEnumeration<Value>) {
      const auto names = enumeration_names(value);
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] != text) continue;
        value = static_cast<Value>(i);
        return true;
      }
      return false;
    } else {
      if (!text.empty() && text.front() == '+') text.remove_prefix(1);
      Value found{};
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), found);
      if (error != std::errc() || end != text.data() + text.size()) return false;
      value = found;
      return true;
    }
  }
}

// The form of a value of this type: "a number", "true or false", "cubic or sum".
template <typename Value>
std::string type_words() {
  if constexpr (std::same_as<Value, bool>) {
    return "true or false";
  } else if constexpr (NamedEnumeration<Value>) {
    std::string words;
    const auto names = enumeration_names(Value{});
    for (std::size_t i = 0; i < names.size(); ++i) {
      words += i == 0 ? "" : i + 1 == names.size() ? " or " : ", ";
      words += names[i];
    }
    return words;
  } else if constexpr (WholeNumber<Value>) {
    return "a whole number";
  } else if constexpr (std::floating_point<Value>) {
    return "a number";
  } else {
    return "a text";
  }
}

}  // namespace bodkin
