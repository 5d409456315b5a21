#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace bodkin::imaging {

// Escapes text for XML and HTML, between tags and inside quotes. Characters that XML forbids become spaces.
std::string escape_markup(std::string_view text);
// The text with U+FFFD in place of every byte that is not part of well-formed UTF-8, and control characters as
// spaces.
std::string printable_utf8(std::string_view text);
std::string base64(std::string_view bytes);
// "data:TYPE;base64,..."
std::string data_uri(std::string_view type, std::string_view bytes);
// "#rrggbb"
std::string css_colour(std::uint32_t colour);

}  // namespace bodkin::imaging
