#include "haptics/drivers/driver_settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "haptics/drivers/driver_adapter.h"

namespace bodkin::haptics {

namespace {

[[noreturn]] void refuse(const std::string& message) {
  throw DriverFailure(BODKIN_BAD_SETTINGS, message);
}

std::string plain(double value) {
  char digits[32];
  const auto end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
  return {digits, end};
}

}  // namespace

DriverSettings::DriverSettings(std::string_view words, std::initializer_list<std::string_view> known) {
  while (true) {
    words.remove_prefix(std::min(words.find_first_not_of(" \t"), words.size()));
    if (words.empty()) return;
    const std::size_t equals = words.find_first_of("= \t");
    if (equals == std::string_view::npos || words[equals] != '=') {
      refuse("the setting '" + std::string(words.substr(0, equals)) + "' is not of the form key=value");
    }
    const std::string key(words.substr(0, equals));
    words.remove_prefix(equals + 1);
    const bool quoted = words.starts_with('"');
    if (quoted) words.remove_prefix(1);
    const std::size_t end = quoted ? words.find('"') : std::min(words.find_first_of(" \t"), words.size());
    if (end == std::string_view::npos) refuse("the setting '" + key + "' lacks its second quotation mark");
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      std::string list;
      for (const std::string_view name : known) list += (list.empty() ? "" : ", ") + std::string(name);
      refuse("there is no setting '" + key + "', expected " + (list.empty() ? "none" : "one of " + list));
    }
    values_[key] = words.substr(0, end);
    words.remove_prefix(std::min(end + (quoted ? 1 : 0), words.size()));
  }
}

std::string DriverSettings::text(const std::string& key, const std::string& otherwise) const {
  const auto found = values_.find(key);
  return found == values_.end() ? otherwise : found->second;
}

double DriverSettings::number(const std::string& key, double otherwise, double low, double high) const {
  const auto found = values_.find(key);
  if (found == values_.end()) return otherwise;
  const std::string& text = found->second;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || !std::isfinite(value) || value < low || value > high) {
    refuse("the setting " + key + " is '" + text + "', expected a number from " + plain(low) + " to " + plain(high));
  }
  return value;
}

bool DriverSettings::flag(const std::string& key, bool otherwise) const {
  const std::string value = text(key, otherwise ? "yes" : "no");
  if (value != "yes" && value != "no") refuse("the setting " + key + " is '" + value + "', expected yes or no");
  return value == "yes";
}

}  // namespace bodkin::haptics
