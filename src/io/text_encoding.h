#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bodkin::io {

// The length in bytes of the character at `position`: well-formed UTF-8 of a character that XML 1.0 allows (no
// control characters but tab, line feed and carriage return); 0 when all are valid.
std::size_t character_length(std::string_view text, std::size_t position) noexcept;

// The text with every byte that is not part of such a character replaced by U+FFFD.
std::string valid_text(std::string_view text);

// The first 60 bytes, with a question mark for every one that is not printable ASCII: a quotation from a damaged file
// must not corrupt a terminal.
std::string printable(std::string_view text);

}  // namespace bodkin::io
