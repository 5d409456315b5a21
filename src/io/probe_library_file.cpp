#include "io/probe_library_file.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "core/error.h"
#include "io/resources.h"
#include "io/settings_xml.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

constexpr std::size_t largest_probe_library = 4 << 20;  // bytes

// Names must differ in more than case.
std::string small_letters(std::string_view name) {
  std::string small(name);
  for (char& letter : small) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return small;
}

anatomy::UltrasoundProbe probe_from(const XmlElement& element, const std::string& origin) {
  SettingsTree tree{.name = element.name, .values = element.attributes, .children = {}, .line = element.line};
  tree.values.emplace_back("source", one_line(element.child("source")->text));
  anatomy::UltrasoundProbe probe;
  read_settings(probe, tree, origin);
  anatomy::check(probe, fmt::format("{}, line {}", origin, element.line));
  return probe;
}

}  // namespace

std::vector<anatomy::UltrasoundProbe> parse_probes(std::string_view document, const std::string& origin) {
  const XmlElement root = XmlSchema("probes.xsd").read(document, origin, {.root = "probe_library"});
  std::vector<anatomy::UltrasoundProbe> probes;
  std::map<std::string, int> line_of_name;
  for (const XmlElement& element : root.children) {
    probes.push_back(probe_from(element, origin));
    const std::string& name = probes.back().name;
    if (const auto [first, fresh] = line_of_name.emplace(small_letters(name), element.line); !fresh) {
      fail_at(
          origin, element.line,
          fmt::format(
              "probe name is '{}', which line {} uses already; names that differ only in capitals are the same name",
              name, first->second));
    }
  }
  return probes;
}

std::vector<anatomy::UltrasoundProbe> read_probes(const std::filesystem::path& file) {
  return parse_probes(read_text_file(file, largest_probe_library), file.string());
}

std::vector<anatomy::UltrasoundProbe> default_probes() {
  return read_probes(shared_file("probes.xml"));
}

std::string probes_xml(std::span<const anatomy::UltrasoundProbe> probes) {
  XmlWriter xml;
  xml.open("probe_library");
  xml.attribute("version", 1);
  for (const anatomy::UltrasoundProbe& probe : probes) {
    xml.open("probe");
    for (const auto& [name, value] : settings_tree("probe", probe).values)
      if (name != "source") xml.attribute(name, value);
    xml.text_element("source", probe.source);
    xml.close();
  }
  xml.close();
  return xml.finish();
}

const anatomy::UltrasoundProbe& find_probe(std::span<const anatomy::UltrasoundProbe> probes, std::string_view name) {
  const std::string wanted = small_letters(name);
  const auto found = std::find_if(probes.begin(), probes.end(), [&wanted](const anatomy::UltrasoundProbe& probe) {
    return small_letters(probe.name) == wanted;
  });
  if (found != probes.end()) return *found;
  std::string names;
  for (const anatomy::UltrasoundProbe& probe : probes) names += (names.empty() ? "" : ", ") + probe.name;
  throw InputError(fmt::format("there is no ultrasound probe {}, expected one of: {}", in_quotes(name), names));
}

anatomy::UltrasoundProbe find_probe(std::string_view name) {
  return find_probe(default_probes(), name);
}

}  // namespace bodkin::io
