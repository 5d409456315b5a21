#include "cli/pane_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::cli {

namespace {

constexpr int frame_width = 400, frame_height = 400;  // pixels of the picture

double number_of(std::string_view name, std::string_view digits, const char* unit) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc() && end == digits.data() + digits.size() && std::isfinite(number)) return number;
  throw InputError(fmt::format("--ultrasound: {} is '{}', expected a number of {}", name, digits, unit));
}

struct PaneNumber {
  std::string_view name;
  const char* unit;
  double low, high;
  std::optional<double> value;
};

}  // namespace

station::UltrasoundRequest pane_request(const std::string& words) {
  station::UltrasoundRequest options;
  options.view = "needle";
  options.size = fmt::format("{}x{}", frame_width, frame_height);
  options.lines = options.samples = 300;
  std::array<PaneNumber, 6> numbers = {{{"press_mm", "mm", -60.0, 40.0, {}},
                                        {"depth_mm", "mm", 10.0, 400.0, {}},
                                        {"gain_dB", "dB", -40.0, 40.0, {}},
                                        {"dynamic_range_dB", "dB", 20.0, 120.0, {}},
                                        {"focus_mm", "mm", 5.0, 400.0, {}},
                                        {"frequency_MHz", "MHz", 1.0, 30.0, {}}}};
  std::string_view rest = words;
  bool named = false;
  while (true) {
    const auto first = rest.find_first_not_of(" \t");
    if (first == std::string_view::npos) break;
    const auto end = std::min(rest.find_first_of(" \t", first), rest.size());
    const std::string_view word = rest.substr(first, end - first);
    rest.remove_prefix(end);
    const auto sign = word.find('=');
    if (sign == std::string_view::npos) {
      if (named) {
        throw InputError(
            fmt::format("--ultrasound: '{}' after the probe {}, expected SETTING=VALUE", word, options.probe));
      }
      named = true;
      options.probe = std::string(word);
      continue;
    }
    const std::string_view name = word.substr(0, sign), value = word.substr(sign + 1);
    if (name == "view") {
      options.view = std::string(value);
    } else if (name == "at") {
      options.at = std::string(value);
    } else if (name == "from") {
      options.from = std::string(value);
    } else {
      const auto number = std::find_if(numbers.begin(), numbers.end(), [&](const auto& n) { return n.name == name; });
      if (number == numbers.end()) {
        throw InputError(fmt::format(
            "--ultrasound: there is no setting '{}', expected view, at, from, press_mm, depth_mm, gain_dB, "
            "dynamic_range_dB, focus_mm or frequency_MHz",
            name));
      }
      number->value = number_of(name, value, number->unit);
      if (*number->value < number->low || *number->value > number->high) {
        throw InputError(
            fmt::format("--ultrasound: {} is '{}', expected {:g} to {:g}", name, value, number->low, number->high));
      }
    }
  }
  options.press = numbers[0].value;
  options.depth = numbers[1].value;
  options.gain = numbers[2].value.value_or(options.gain);
  options.dynamic_range = numbers[3].value.value_or(options.dynamic_range);
  options.focus = numbers[4].value;
  options.frequency = numbers[5].value;
  try {
    station::choose_ultrasound(options);
  } catch (const InputError& refused) {  // said of the one option here that holds them all
    throw InputError(fmt::format("--ultrasound: {}", refused.what()));
  }
  return options;
}

}  // namespace bodkin::cli
