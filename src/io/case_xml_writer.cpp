#include "io/case_xml.h"
#include "io/haptics_xml.h"
#include "io/settings_xml.h"
#include "io/xml_writer.h"

namespace bodkin::io {

namespace {

constexpr const char* position_names[3] = {"x_mm", "y_mm", "z_mm"};

void write_file(XmlWriter& xml, const char* element, const std::string& file, const std::string& digest) {
  xml.open(element);
  xml.attribute("file", file);
  xml.optional("digest", digest);
}

void write_volumes(XmlWriter& xml, const anatomy::CaseDescription& description) {
  xml.open("volumes");
  write_file(xml, "ct", description.ct_file, description.ct_digest);
  xml.close();
  if (!description.structures_file.empty() || !description.structures.empty()) {
    write_file(xml, "structures", description.structures_file, description.structures_digest);
    for (const anatomy::Structure& structure : description.structures) {
      xml.open("structure");
      xml.attribute("label", static_cast<int>(structure.label));
      xml.attribute("name", structure.name);
      xml.optional("tissue", structure.tissue);
      if (structure.critical) xml.attribute("critical", true);
      xml.close();
    }
    xml.close();
  }
  write_file(xml, "tissues", description.tissues_file, description.tissues_digest);
  xml.close();
  xml.close();
}

void write_procedure(XmlWriter& xml, const anatomy::Procedure& procedure) {
  xml.open("procedure");
  xml.attribute("name", procedure.name);
  xml.optional("target_tissue", procedure.target_tissue);
  xml.attribute("target_tolerance_mm", procedure.target_tolerance);
  if (procedure.path) {
    xml.open("entry");
    xml.coordinates(position_names, procedure.path->entry);
    xml.close();
    xml.open("target");
    xml.coordinates(position_names, procedure.path->target);
    xml.close();
  }
  xml.close();
}

}  // namespace

std::string case_xml(const anatomy::CaseDescription& description) {
  XmlWriter xml;
  xml.open("case");
  xml.attribute("version", 1);
  xml.attribute("name", description.name);
  xml.optional("created_by", description.created_by);
  if (!description.description.empty()) xml.text_element("description", description.description);
  write_volumes(xml, description);
  if (!description.tissue_library_file.empty()) {
    write_file(xml, "tissue_library", description.tissue_library_file, {});
    xml.close();
  }
  write_settings(xml, settings_tree("needle", description.needle));
  write_settings(xml, settings_tree("device", description.device));
  write_haptics(xml, description.haptics);
  if (!description.landmarks.empty()) {
    xml.open("landmarks");
    for (const anatomy::Landmark& landmark : description.landmarks) {
      xml.open("landmark");
      xml.attribute("name", landmark.name);
      xml.coordinates(position_names, landmark.position);
      xml.close();
    }
    xml.close();
  }
  write_procedure(xml, description.procedure);
  if (description.breathing) write_settings(xml, settings_tree("breathing", *description.breathing));
  if (!description.notes.empty()) {
    xml.open("notes");
    for (const std::string& note : description.notes) xml.text_element("note", note);
    xml.close();
  }
  xml.close();
  return xml.finish();
}

std::string device_xml(const anatomy::DeviceLimits& device) {
  XmlWriter xml;
  write_settings(xml, settings_tree("device", device));
  return xml.finish();
}

}  // namespace bodkin::io
