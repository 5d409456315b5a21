#include "io/text_encoding.h"

namespace bodkin::io {

std::size_t character_length(std::string_view text, std::size_t position) noexcept {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(position);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  unsigned code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(position + i) & 0xC0U) != 0x80U) return 0;
    code = (code << 6U) | (byte(position + i) & 0x3FU);
  }
  const bool shortest = code >= (length == 4 ? 0x10000U : length == 3 ? 0x800U : 0x80U);
  const bool allowed = code <= 0x10FFFFU && (code < 0xD800U || code > 0xDFFFU) && code != 0xFFFEU && code != 0xFFFFU;
  return shortest && allowed ? length : 0;
}

std::string valid_text(std::string_view text) {
  std::string valid;
  for (std::size_t position = 0; position < text.size();) {
    const std::size_t length = character_length(text, position);
    valid += length == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(position, length);
    position += length == 0 ? 1 : length;
  }
  return valid;
}

std::string printable(std::string_view text) {
  std::string result(text.substr(0, 60));
  for (char& letter : result) {
    if (letter < ' ' || letter > '~') letter = '?';
  }
  return result;
}

}  // namespace bodkin::io
