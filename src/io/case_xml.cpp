#include "io/case_xml.h"

#include <map>

#include <fmt/format.h>

#include "core/error.h"
#include "io/haptics_xml.h"
#include "io/label_scheme.h"
#include "io/resources.h"
#include "io/settings_xml.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

std::string file_of(const XmlElement& element, const std::string& origin) {
  std::string name = element.string("file");
  if (!is_inside_name(name)) {
    fail_at(origin, element.line,
            fmt::format("{} file is {}, expected a file name inside the case folder, without '..' or a leading '/'",
                        element.name, in_quotes(name)));
  }
  return name;
}

void read_volumes(const XmlElement& volumes, const std::string& origin, anatomy::CaseDescription& description) {
  const XmlElement& ct = *volumes.child("ct");
  description.ct_file = file_of(ct, origin);
  description.ct_digest = ct.string("digest");
  const XmlElement& tissues = *volumes.child("tissues");
  description.tissues_file = file_of(tissues, origin);
  description.tissues_digest = tissues.string("digest");
  const XmlElement* structures = volumes.child("structures");
  if (structures == nullptr) return;
  description.structures_file = file_of(*structures, origin);
  description.structures_digest = structures->string("digest");
  std::map<int, int> line_of_label;
  for (const XmlElement& element : structures->children) {
    anatomy::Structure entry;
    entry.label = static_cast<std::uint16_t>(element.integer("label", 0));
    entry.name = element.string("name");
    entry.tissue = element.string("tissue");
    entry.critical = element.boolean("critical", entry.critical);
    if (const auto [first, fresh] = line_of_label.emplace(entry.label, element.line); !fresh) {
      fail_at(origin, element.line,
              fmt::format("structure label is {}, which line {} uses already", entry.label, first->second));
    }
    description.structures.push_back(std::move(entry));
  }
}

}  // namespace

anatomy::Needle read_needle(const XmlElement& element, const std::string& origin) {
  const bool outer = element.find("outer_diameter_mm") != nullptr,
             inner = element.find("inner_diameter_mm") != nullptr;
  if (outer != inner) {
    fail_at(origin, element.line,
            fmt::format("needle has one of outer_diameter_mm and inner_diameter_mm, expected both or "
                        "neither (a solid needle has an inner_diameter_mm of 0)"));
  }
  auto needle = settings_from<anatomy::Needle>(element, origin);
  if (outer) return needle;
  const auto size = anatomy::gauge_size(needle.gauge);
  if (!size) {
    fail_at(origin, element.line,
            fmt::format("needle gauge is {}, expected 10 to 34, or outer_diameter_mm and inner_diameter_mm "
                        "beside it",
                        needle.gauge));
  }
  needle.outer_diameter = size->outer_diameter;
  needle.inner_diameter = size->inner_diameter;
  return needle;
}

anatomy::DeviceLimits read_device(const XmlElement& element, const std::string& origin) {
  return settings_from<anatomy::DeviceLimits>(element, origin);
}

anatomy::DeviceLimits parse_device_xml(std::string_view document, const std::string& origin,
                                       const XmlSchema& schema) {
  return read_device(schema.read(document, origin, {.root = "device"}), origin);
}

namespace {

Vec3 read_point(const XmlElement& element) {
  return {element.number("x_mm", 0.0), element.number("y_mm", 0.0), element.number("z_mm", 0.0)};
}

std::vector<anatomy::Landmark> read_landmarks(const XmlElement& element, const std::string& origin) {
  std::vector<anatomy::Landmark> landmarks;
  std::map<std::string, int> line_of_name;
  for (const XmlElement& child : element.children) {
    const std::string name = child.string("name");
    if (const auto [first, fresh] = line_of_name.emplace(name, child.line); !fresh) {
      fail_at(origin, child.line,
              fmt::format("landmark name is {}, which line {} uses already", in_quotes(name), first->second));
    }
    landmarks.push_back({name, read_point(child)});
  }
  return landmarks;
}

anatomy::Procedure read_procedure(const XmlElement& element, const std::string& origin) {
  constexpr double shortest = 0.1;  // mm; a shorter path has no meaningful direction
  anatomy::Procedure procedure;
  procedure.name = element.string("name", procedure.name);
  procedure.target_tissue = element.string("target_tissue");
  procedure.target_tolerance = element.number("target_tolerance_mm", procedure.target_tolerance);
  if (const XmlElement* entry = element.child("entry"); entry != nullptr) {
    const XmlElement& target = *element.child("target");
    procedure.path = anatomy::NeedlePath{read_point(*entry), read_point(target)};
    if (procedure.path->length() < shortest) {
      fail_at(origin, target.line,
              fmt::format("target is {} mm from the entry on line {}, expected at least {} mm",
                          procedure.path->length(), entry->line, shortest));
    }
  }
  return procedure;
}

// Tissues that the case names must be in its library.
void check_tissues(const XmlElement& root, const std::string& origin, const anatomy::TissueLibrary& library) {
  const auto require = [&](const XmlElement& element, const char* attribute) {
    const std::string* tissue = element.find(attribute);
    if (tissue == nullptr || tissue->empty() || library.find(*tissue) != nullptr) return;
    fail_at(origin, element.line,
            fmt::format("{} {} is {}, which the tissue library does not have", element.name, attribute,
                        in_quotes(*tissue)));
  };
  if (const XmlElement* structures = root.child("volumes")->child("structures"); structures != nullptr) {
    for (const XmlElement& structure : structures->children) {
      if (!is_resolved_by_construction(structure.string("tissue"))) require(structure, "tissue");
    }
  }
  if (const XmlElement* procedure = root.child("procedure"); procedure != nullptr)
    require(*procedure, "target_tissue");
}

}  // namespace

anatomy::CaseDescription parse_case_xml(std::string_view document, const std::string& origin, const XmlSchema& schema,
                                        const LibraryOf& library_of) {
  const XmlElement root = schema.read(document, origin, {.root = "case"});
  anatomy::CaseDescription description;
  description.name = root.string("name");
  description.created_by = root.string("created_by");
  if (const XmlElement* text = root.child("description"); text != nullptr) description.description = text->text;
  read_volumes(*root.child("volumes"), origin, description);
  if (const XmlElement* library = root.child("tissue_library"); library != nullptr) {
    description.tissue_library_file = file_of(*library, origin);
  }
  description.needle = read_needle(*root.child("needle"), origin);
  if (const XmlElement* device = root.child("device"); device != nullptr)
    description.device = read_device(*device, origin);
  if (const XmlElement* haptics = root.child("haptics"); haptics != nullptr)
    description.haptics = read_haptics(*haptics, origin);
  if (const XmlElement* landmarks = root.child("landmarks"); landmarks != nullptr) {
    description.landmarks = read_landmarks(*landmarks, origin);
  }
  if (const XmlElement* procedure = root.child("procedure"); procedure != nullptr) {
    description.procedure = read_procedure(*procedure, origin);
  }
  if (const XmlElement* breathing = root.child("breathing"); breathing != nullptr)
    description.breathing = settings_from<anatomy::Breathing>(*breathing, origin);
  if (const XmlElement* notes = root.child("notes"); notes != nullptr) {
    for (const XmlElement& note : notes->children) description.notes.push_back(note.text);
  }
  check_tissues(root, origin, library_of(description.tissue_library_file));
  return description;
}

}  // namespace bodkin::io
