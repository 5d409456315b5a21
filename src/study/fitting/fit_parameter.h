#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "core/parameter.h"
#include "core/settings_check.h"
#include "io/xml_document.h"

namespace bodkin::study {

// One number of a model that a curve may determine.
struct FitParameter {
  std::string name;
  std::string unit;
  double low = 0.0, high = 0.0;  // what the fit looks through: the model's own range or a part of it
  double usual = 0.0;            // value where nothing better is known; also its size for scaling, if the guess is 0
  bool fitted = true;            // false: kept unless the user frees it
};

// In what a parameter of a fit differs from its declaration in the model's table of parameters.
struct FitDifference {
  std::string_view name;        // empty: the declared name without its unit
  std::optional<double> usual;  // instead of the declared default
  double least = -unbounded,
         most = unbounded;  // both included; the part of the declared range that is looked through
  bool fitted = true;
};

// "stiffness_N_per_mm" in "N/mm" is "stiffness".
std::string name_without_unit(std::string_view name, std::string_view unit);

// The parameter of a fit that the table of `Settings` declares for `member`.
template <Parameterized Settings>
FitParameter fit_parameter(double Settings::*member, const FitDifference& difference = {}) {
  FitParameter found;
  const Settings defaults;
  for_each_parameter(
      [&](const auto& parameter, const auto& value) {
        if (static_cast<const void*>(&value) != &(defaults.*member)) return;
        found.name = difference.name.empty() ? name_without_unit(parameter.name, parameter.unit) : difference.name;
        found.unit = parameter.unit;
        found.low = std::max(parameter.range.low, difference.least);
        found.high = std::min(parameter.range.high, difference.most);
      },
      defaults);
  found.usual = difference.usual.value_or(defaults.*member);
  found.fitted = difference.fitted;
  return found;
}

// An element of a tissue library or a case that states these members of the settings, under their declared names.
template <Parameterized Settings, typename... Members>
io::XmlElement element_of(std::string name, const Settings& settings, Members... members) {
  io::XmlElement element;
  element.name = std::move(name);
  (element.attributes.emplace_back(name_of_member(settings, &(settings.*members)).name,
                                   value_text(settings.*members)),
   ...);
  return element;
}

}  // namespace bodkin::study
