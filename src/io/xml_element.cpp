#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "core/error.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

// The schema collapses white space around numbers and allows a plus sign, from_chars neither.
template <typename Number>
Number parsed(std::string_view text, Number fallback) noexcept {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return fallback;
  text.remove_prefix(first);
  if (text.front() == '+') text.remove_prefix(1);
  Number value = 0;  // also for numbers too small to represent, unchanged by from_chars
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

const std::string* XmlElement::find(std::string_view attribute) const noexcept {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [attribute](const auto& entry) { return entry.first == attribute; });
  return found == attributes.end() ? nullptr : &found->second;
}

const XmlElement* XmlElement::child(std::string_view element) const noexcept {
  const auto found = std::find_if(children.begin(), children.end(),
                                  [element](const XmlElement& entry) { return entry.name == element; });
  return found == children.end() ? nullptr : &*found;
}

std::string XmlElement::string(std::string_view attribute, const std::string& fallback) const {
  const std::string* value = find(attribute);
  return value == nullptr ? fallback : *value;
}

double XmlElement::number(std::string_view attribute, double fallback) const noexcept {
  const std::string* value = find(attribute);
  return value == nullptr ? fallback : parsed(*value, fallback);
}

int XmlElement::integer(std::string_view attribute, int fallback) const noexcept {
  const std::string* value = find(attribute);
  return value == nullptr ? fallback : parsed(*value, fallback);
}

bool XmlElement::boolean(std::string_view attribute, bool fallback) const noexcept {
  const std::string* value = find(attribute);
  return value == nullptr ? fallback : value->find_first_of("t1") != std::string::npos;
}

void fail_at(const std::string& origin, int line, const std::string& sentence) {
  if (line == 0) throw InputError(fmt::format("{}: {}", origin, sentence));
  throw InputError(fmt::format("{}, line {}: {}", origin, line, sentence));
}

std::string in_quotes(std::string_view value) {
  constexpr std::size_t longest = 60;
  std::string shown = "'";
  for (const char c : value.substr(0, longest)) shown += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  // A cut must not leave half a UTF-8 character.
  if (value.size() > longest) {
    while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xC0) == 0x80) shown.pop_back();
    if (static_cast<unsigned char>(shown.back()) >= 0xC0) shown.pop_back();
    shown += "...";
  }
  return shown + "'";
}

std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!blank) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  if (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

}  // namespace bodkin::io
