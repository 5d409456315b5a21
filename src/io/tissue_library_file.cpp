#include "io/tissue_library_file.h"

#include <map>

#include <fmt/format.h>

#include "core/error.h"
#include "io/resources.h"
#include "io/settings_xml.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

constexpr std::size_t library_limit = 4 << 20;  // bytes

// A tissue without the models' elements. XML writes the colour as #RRGGBB and the source as an element.
SettingsTree tissue_tree(const XmlElement& element) {
  SettingsTree tree{.name = element.name, .values = element.attributes, .children = {}, .line = element.line};
  for (auto& [name, value] : tree.values)
    if (name == "colour") value = std::to_string(std::stoul(value.substr(1), nullptr, 16));
  tree.values.emplace_back("source", one_line(element.child("source")->text));
  return tree;
}

}  // namespace

void read_tissue_forces(const XmlElement& element, const std::string& origin, anatomy::TissueProperties& entry) {
  for_each_inside(
      [&](const auto& model, auto& properties) {
        using Properties = std::remove_cvref_t<decltype(properties)>;
        if (const XmlElement* child = element.child(model.name); child != nullptr)
          properties = settings_from<Properties>(*child, origin);
      },
      entry);
}

namespace {

anatomy::TissueProperties tissue_from(const XmlElement& element, const std::string& origin) {
  auto entry = settings_from<anatomy::TissueProperties>(tissue_tree(element), origin);
  read_tissue_forces(element, origin, entry);
  return entry;
}

}  // namespace

anatomy::TissueLibrary parse_tissue_library(std::string_view document, const std::string& origin,
                                            const XmlSchema& schema) {
  const XmlElement root = schema.read(document, origin);
  std::vector<anatomy::TissueProperties> tissues;
  std::map<int, int> line_of_id;
  std::map<std::string, int> line_of_name;
  for (const XmlElement& element : root.children) {
    const anatomy::TissueProperties entry = tissue_from(element, origin);
    if (const auto [first, fresh] = line_of_id.emplace(entry.id, element.line); !fresh) {
      fail_at(origin, element.line,
              fmt::format("tissue id is {}, which line {} uses already", entry.id, first->second));
    }
    if (const auto [first, fresh] = line_of_name.emplace(entry.name, element.line); !fresh) {
      fail_at(origin, element.line,
              fmt::format("tissue name is '{}', which line {} uses already", entry.name, first->second));
    }
    tissues.push_back(entry);
  }
  if (!line_of_id.contains(anatomy::tissue::air)) {
    fail_at(origin, root.line,
            fmt::format("there is no tissue with id {}, expected one for air", anatomy::tissue::air));
  }
  return anatomy::TissueLibrary(std::move(tissues));
}

anatomy::TissueLibrary read_tissue_library(const std::filesystem::path& file) {
  return parse_tissue_library(read_text_file(file, library_limit), file.string(), XmlSchema("tissues.xsd"));
}

std::string tissue_library_xml(const anatomy::TissueLibrary& library) {
  XmlWriter xml;
  xml.open("tissue_library");
  xml.attribute("version", 1);
  const anatomy::TissueProperties nothing;
  for (const anatomy::TissueProperties& tissue : library.tissues()) {
    xml.open("tissue");
    xml.attribute("id", static_cast<int>(tissue.id));
    xml.attribute("name", tissue.name);
    xml.attribute("title", tissue.title);
    xml.attribute("colour", fmt::format("#{:06X}", tissue.colour));
    xml.attribute("hounsfield_HU", tissue.hounsfield);
    xml.attribute("hounsfield_noise_HU", tissue.hounsfield_noise);
    for_each_inside(
        [&xml](const auto& model, const auto& properties, const auto& absent) {
          // A model without values for a tissue has no element; that of `layered` is required.
          if (model.name == "layered" || !same_parameters(properties, absent))
            write_settings(xml, settings_tree(std::string(model.name), properties));
        },
        tissue, nothing);
    xml.text_element("source", tissue.source);
    xml.close();
  }
  xml.close();
  return xml.finish();
}

anatomy::TissueLibrary default_tissue_library() {
  return read_tissue_library(shared_file("tissues.xml"));
}

}  // namespace bodkin::io
