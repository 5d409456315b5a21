#include "io/force_choice.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "anatomy/case.h"
#include "core/error.h"
#include "io/haptics_xml.h"
#include "io/xml_document.h"
#include "io/xml_writer.h"

namespace bodkin::io {

namespace {

constexpr std::string_view blanks = " \t\r\n";

std::vector<std::string> split(std::string_view text, std::string_view separators) {
  std::vector<std::string> pieces;
  while (true) {
    const auto first = text.find_first_not_of(separators);
    if (first == std::string_view::npos) return pieces;
    const auto end = std::min(text.find_first_of(separators, first), text.size());
    pieces.emplace_back(text.substr(first, end - first));
    text.remove_prefix(end);
  }
}

// A valid name of an element or attribute.
bool is_name(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !text.empty() && letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

[[noreturn]] void fail(const std::string& origin, const std::string& sentence) {
  throw InputError(fmt::format("{}: {}", origin, sentence));
}

std::string listed(const auto& names) {
  std::string text;
  for (const std::string_view name : names)
    text += fmt::format("{}{}", text.empty() ? "" : name == *std::prev(std::end(names)) ? " or " : ", ", name);
  return text;
}

// Opens the element of "name setting=value setting=value".
void open_element(XmlWriter& xml, const std::string& text, const std::string& origin) {
  const std::vector<std::string> words = split(text, blanks);
  if (words.empty() || !is_name(words.front())) {
    fail(origin, fmt::format("{} does not begin with a name, expected NAME SETTING=VALUE SETTING=VALUE ...",
                             in_quotes(text)));
  }
  xml.open(words.front());
  std::set<std::string> seen;
  for (auto word = words.begin() + 1; word != words.end(); ++word) {
    const auto sign = word->find('=');
    const std::string name = word->substr(0, sign);
    if (sign == std::string::npos || !is_name(name)) {
      fail(origin, fmt::format("{} has {}, expected SETTING=VALUE without blanks", words.front(), in_quotes(*word)));
    }
    if (!seen.insert(name).second) fail(origin, fmt::format("{} {} is given twice", words.front(), name));
    xml.attribute(name, word->substr(sign + 1));
  }
}

// The element of a text: parts after semicolons lie inside the first.
void write_element(XmlWriter& xml, std::string_view text, const auto& names, const char* what,
                   const std::string& origin) {
  const std::vector<std::string> elements = split(text, ";");
  const std::vector<std::string> words = elements.empty() ? elements : split(elements.front(), blanks);
  if (words.empty()) fail(origin, fmt::format("is empty, expected {}", listed(names)));
  if (std::find(std::begin(names), std::end(names), words.front()) == std::end(names)) {
    fail(origin, fmt::format("there is no {} {}, expected {}", what, in_quotes(words.front()), listed(names)));
  }
  open_element(xml, elements.front(), origin);
  for (auto child = elements.begin() + 1; child != elements.end(); ++child) {
    open_element(xml, *child, origin);
    xml.close();
  }
  xml.close();
}

// Reads the contents that `write` puts into the element `role` of <haptics>.
anatomy::HapticSettings read_role(const char* role, const std::string& origin, const auto& write) {
  XmlWriter xml;
  xml.open("haptics");
  xml.open(role);
  write(xml);
  const XmlElement root = XmlSchema("case.xsd").read(xml.finish(), origin, {.root = "haptics", .lines = false});
  return read_haptics(root, origin);
}

}  // namespace

anatomy::ResistanceSettings parse_resistance(std::string_view text, const std::string& origin) {
  return read_role("resistance", origin,
                   [&](XmlWriter& xml) { write_element(xml, text, anatomy::resistance_names, "resistance", origin); })
      .resistance;
}

anatomy::ConstraintSettings parse_constraint(std::string_view text, const std::string& origin) {
  return read_role("constraint", origin,
                   [&](XmlWriter& xml) { write_element(xml, text, anatomy::constraint_names, "constraint", origin); })
      .constraint;
}

anatomy::ForceParts parse_parts(const std::vector<std::string>& texts, const std::string& origin) {
  if (texts.size() == 1 && split(texts.front(), blanks) == std::vector<std::string>{"none"}) return {};
  return read_role("parts", origin,
                   [&](XmlWriter& xml) {
                     for (const std::string& text : texts) write_element(xml, text, part_names, "part", origin);
                   })
      .parts;
}

ForceTexts force_texts(const anatomy::HapticSettings& haptics) {
  const auto text_of = [](std::string_view name, const auto& settings) {
    return tree_text(settings_tree(std::string(name), settings));
  };
  ForceTexts texts;
  texts.resistance =
      std::visit([&](const auto& settings) { return text_of(anatomy::name_of(haptics.resistance), settings); },
                 haptics.resistance);
  texts.constraint =
      std::visit([&](const auto& settings) { return text_of(anatomy::name_of(haptics.constraint), settings); },
                 haptics.constraint);
  for (const SettingsTree& part : settings_tree("parts", haptics.parts).children)
    texts.parts.push_back(tree_text(part));
  return texts;
}

}  // namespace bodkin::io
