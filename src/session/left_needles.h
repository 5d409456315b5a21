#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/needle_path.h"

namespace bodkin::session {

inline constexpr std::size_t most_left_needles = 100;

// Needles that were left in the body as the header of a session keeps them: a line for each, entry and tip in mm. The
// numbers come back bit for bit.
std::string left_needles_text(const std::vector<anatomy::NeedlePath>& left);
// Nothing for a text that is not one.
std::optional<std::vector<anatomy::NeedlePath>> parse_left_needles(const std::string& text);

// Throws InputError for needles that no body can have: too many, without length, or places that are not finite.
void check_left_needles(const std::vector<anatomy::NeedlePath>& left);

}  // namespace bodkin::session
