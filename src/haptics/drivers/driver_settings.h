#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

namespace bodkin::haptics {

// The "key=value" words that a user gives to a driver; a value with spaces is in double quotes.
class DriverSettings {
 public:
  // Throws DriverFailure{BODKIN_BAD_SETTINGS} for words that are not of the form key=value and for keys not among
  // `known`.
  DriverSettings(std::string_view words, std::initializer_list<std::string_view> known);

  std::string text(const std::string& key, const std::string& otherwise) const;
  // Throws DriverFailure{BODKIN_BAD_SETTINGS} outside [low, high].
  double number(const std::string& key, double otherwise, double low, double high) const;
  // "yes" or "no".
  bool flag(const std::string& key, bool otherwise) const;

 private:
  std::map<std::string, std::string> values_;
};

}  // namespace bodkin::haptics
