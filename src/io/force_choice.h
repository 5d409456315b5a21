#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "anatomy/force_settings.h"

namespace bodkin::anatomy {
struct HapticSettings;
}  // namespace bodkin::anatomy

namespace bodkin::io {

// Force models as people type them: a name and settings, with the names, units, ranges and defaults of case files.
//   tracking_wall catch_up_s=0.3 leash=true
//   tracking_wall; layer from_mm=0 force_N=1.5; layer from_mm=4 force_N=0.4     elements inside, after semicolons
// The text is converted to the element of a case file and validated against the same schema. `origin` names it in
// messages. Throw InputError naming the setting, what was found and what was expected.

anatomy::ResistanceSettings parse_resistance(std::string_view text, const std::string& origin);

anatomy::ConstraintSettings parse_constraint(std::string_view text, const std::string& origin);

inline constexpr auto part_names =
    std::apply([](const auto&... part) { return std::array<std::string_view, sizeof...(part)>{part.name...}; },
               anatomy::ForceParts::parameters());

// One text for each part; a single "none" means no parts.
anatomy::ForceParts parse_parts(const std::vector<std::string>& texts, const std::string& origin);

// Settings as texts that the functions above read back to the same bits.
struct ForceTexts {
  std::string resistance;
  std::string constraint;
  std::vector<std::string> parts;  // empty: none
};
ForceTexts force_texts(const anatomy::HapticSettings& haptics);

}  // namespace bodkin::io
