#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/needle_path.h"

namespace bodkin::session {

inline constexpr std::size_t most_left_needles = 100;

// Needles left in the body, in the format of a session's header: a line for each, entry and tip in mm. Lossless.
std::string left_needles_text(const std::vector<anatomy::NeedlePath>& left);
// Empty for an invalid text.
std::optional<std::vector<anatomy::NeedlePath>> parse_left_needles(const std::string& text);

// Throws InputError for invalid needles: too many, of zero length, or with positions that are not finite.
void check_left_needles(const std::vector<anatomy::NeedlePath>& left);

}  // namespace bodkin::session
