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
  double low = 0.0, high = 0.0;  // range searched by the fit: the model's own range or a part of it
  double usual = 0.0;            // value if nothing better is known; also its size for scaling, if the guess is 0
  bool fitted = true;            // false: fixed unless the user frees it
};

// The differences of a parameter of a fit from its declaration in the model's parameter table.
struct FitDifference {
  std::string_view name;        // empty: the declared name without its unit
  std::optional<double> usual;  // instead of the declared default
  double least = -unbounded,
         most = unbounded;  // both included; the searched part of the declared range
  bool fitted = true;
};

// The parameter of a fit that the table of `Settings` declares for `member`.
template <Parameterized Settings>
FitParameter fit_parameter(double Settings::*member, const FitDifference& difference = {}) {
  const DeclaredParameter declared = declaration_of(member);
  return {.name = std::string(difference.name.empty() ? name_without_unit(declared.name, declared.unit)
                                                      : difference.name),
          .unit = std::string(declared.unit),
          .low = std::max(declared.range.low, difference.least),
          .high = std::min(declared.range.high, difference.most),
          .usual = difference.usual.value_or(Settings{}.*member),
          .fitted = difference.fitted};
}

// An element of a tissue library or a case that states these members of the settings, under their declared names.
template <Parameterized Settings, typename... Members>
io::XmlElement element_of(std::string name, const Settings& settings, Members... members) {
  io::XmlElement element;
  element.name = std::move(name);
  (element.attributes.emplace_back(declaration_of(members).name, value_text(settings.*members)), ...);
  return element;
}

}  // namespace bodkin::study
