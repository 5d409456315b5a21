#include "core/parameter_value.h"

#include <array>
#include <cmath>

namespace bodkin {

std::string number_text(double value) {
  if (std::isinf(value)) return value > 0.0 ? "INF" : "-INF";
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string number_words(double value) {
  return value == unbounded ? "infinity" : value == -unbounded ? "-infinity" : number_text(value);
}

std::string range_words(const Range& range, std::string_view unit) {
  std::string its_unit;
  if (!unit.empty()) its_unit.append(" ").append(unit);
  if (range.low == -unbounded && range.high == unbounded) return "a finite number";
  if (range.high == unbounded && !range.includes_high) {
    return range.includes_low ? number_words(range.low) + its_unit + " or more"
                              : "more than " + number_words(range.low) + its_unit;
  }
  if (range.high == unbounded) return number_words(range.low) + its_unit + " to infinity";
  if (range.includes_low && range.includes_high)
    return number_words(range.low) + " to " + number_words(range.high) + its_unit;
  return (range.includes_low ? "at least " : "more than ") + number_words(range.low) + " and " +
         (range.includes_high ? "at most " : "less than ") + number_words(range.high) + its_unit;
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view name_without_unit(std::string_view name, std::string_view unit) {
  if (unit.empty()) return name;
  const bool is_inverse = unit.starts_with("1/");
  std::string ending = is_inverse ? "" : "_";
  for (const char letter : unit.substr(is_inverse ? 1 : 0)) {
    if (letter == '/') {
      ending += "_per_";
    } else if (letter == ' ') {
      ending += '_';
    } else if (letter != '^' && letter != '(' && letter != ')') {
      ending += letter;
    }
  }
  if (name.ends_with(ending)) name.remove_suffix(ending.size());
  return name;
}

bool parse_number(std::string_view text, double& value) {
  text = without_blanks(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  if (text == "INF" || text == "-INF") {
    value = text == "INF" ? unbounded : -unbounded;
    return true;
  }
  // from_chars would accept the words inf and nan in any spelling.
  if (text.find_first_not_of("0123456789.eE+-") != std::string_view::npos) return false;
  double found = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), found);
  if (end != text.data() + text.size() || text.empty()) return false;
  // A number too small to represent is read as 0, which from_chars does not store; one too large is rejected.
  if (error == std::errc::result_out_of_range) {
    const auto exponent = text.find_first_of("eE");
    if (exponent == std::string_view::npos || text.find('-', exponent) == std::string_view::npos) return false;
  } else if (error != std::errc()) {
    return false;
  }
  value = found;
  return true;
}

}  // namespace bodkin
