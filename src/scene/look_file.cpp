#include "scene/look_file.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <system_error>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "core/files.h"
#include "io/resources.h"
#include "io/xml_document.h"
#include "io/xml_writer.h"

namespace bodkin::scene {

namespace {

constexpr std::size_t largest_looks_file = 4 << 20;  // bytes

std::filesystem::path looks_file(const std::filesystem::path& folder) {
  return folder / "looks.xml";
}

// "#8a5878"; the schema vouches for the form.
std::uint32_t colour_from(const std::string& text) {
  std::uint32_t colour = 0;
  std::from_chars(text.data() + 1, text.data() + text.size(), colour, 16);
  return colour;
}

Vec3 vector_from(const io::XmlElement& element, const char* x, const char* y, const char* z) {
  return {element.number(x, 0.0), element.number(y, 0.0), element.number(z, 0.0)};
}

Camera camera_from(const io::XmlElement& element, const std::string& origin) {
  Camera camera;
  camera.eye = vector_from(element, "eye_x_mm", "eye_y_mm", "eye_z_mm");
  camera.focus = vector_from(element, "focus_x_mm", "focus_y_mm", "focus_z_mm");
  camera.up = vector_from(element, "up_x", "up_y", "up_z");
  camera.angle = element.number("angle_deg", 30.0) * degree;
  if (camera.distance() < 1.0) io::fail_at(origin, element.line, "camera: eye and focus must be 1 mm apart at least");
  const Vec3 sideways = camera.up.stableNormalized().cross((camera.focus - camera.eye).normalized());
  if (sideways.norm() < 1e-3)
    io::fail_at(origin, element.line, "camera: up must be a direction across the line of sight, from eye to focus");
  return camera;
}

PartLook part_from(const io::XmlElement& element) {
  PartLook part{element.string("name"), {}, {}, {}};
  if (element.find("shown") != nullptr) part.shown = element.boolean("shown", true);
  if (element.find("opacity") != nullptr) part.opacity = element.number("opacity", 1.0);
  if (const std::string* colour = element.find("colour")) part.colour = colour_from(*colour);
  return part;
}

NamedLook look_from(const io::XmlElement& element, const std::string& origin) {
  NamedLook named{element.string("name"), {}, {}};
  const std::string preset = element.string("preset");
  for (const Preset each : presets) {
    if (name_of(each) == preset) named.look.preset = each;
  }
  std::set<std::string> names;
  for (const io::XmlElement& child : element.children) {
    if (child.name == "camera") {
      named.camera = camera_from(child, origin);
      continue;
    }
    named.look.changed.push_back(part_from(child));
    const std::string& name = named.look.changed.back().name;
    if (!names.insert(name).second) {
      io::fail_at(origin, child.line,
                  fmt::format("part {} appears twice in one look; leave one of them out", io::in_quotes(name)));
    }
  }
  return named;
}

void write_camera(const Camera& camera, io::XmlWriter& xml) {
  xml.open("camera");
  xml.coordinates({"eye_x_mm", "eye_y_mm", "eye_z_mm"}, camera.eye);
  xml.coordinates({"focus_x_mm", "focus_y_mm", "focus_z_mm"}, camera.focus);
  xml.coordinates({"up_x", "up_y", "up_z"}, camera.up);
  xml.attribute("angle_deg", camera.angle / degree);
  xml.close();
}

}  // namespace

const NamedLook* CaseLooks::find(std::string_view name) const {
  const auto found =
      std::find_if(looks.begin(), looks.end(), [name](const NamedLook& look) { return look.name == name; });
  return found == looks.end() ? nullptr : &*found;
}

CaseLooks read_looks(const std::filesystem::path& folder) {
  const std::filesystem::path file = looks_file(folder);
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  const std::string origin = file.string();
  const io::XmlElement root =
      io::XmlSchema("looks.xsd").read(io::read_text_file(file, largest_looks_file), origin, {.root = "looks"});
  CaseLooks looks;
  for (const io::XmlElement& element : root.children) {
    NamedLook look = look_from(element, origin);
    if (looks.find(look.name) != nullptr) {
      io::fail_at(origin, element.line,
                  fmt::format("there are two looks called {}; give one another name", io::in_quotes(look.name)));
    }
    looks.looks.push_back(std::move(look));
  }
  looks.opens_with = root.string("opens_with");
  if (!looks.opens_with.empty() && looks.find(looks.opens_with) == nullptr) {
    io::fail_at(origin, root.line,
                fmt::format("looks opens_with is {}, expected the name of a look in this file",
                            io::in_quotes(looks.opens_with)));
  }
  return looks;
}

void write_looks(const CaseLooks& looks, const std::filesystem::path& folder) {
  io::XmlWriter xml;
  xml.open("looks");
  xml.attribute("version", 1);
  xml.optional("opens_with", looks.opens_with);
  for (const NamedLook& named : looks.looks) {
    xml.open("look");
    xml.attribute("name", named.name);
    xml.attribute("preset", std::string(name_of(named.look.preset)));
    if (named.camera) write_camera(*named.camera, xml);
    for (const PartLook& part : named.look.changed) {
      xml.open("part");
      xml.attribute("name", part.name);
      if (part.shown) xml.attribute("shown", *part.shown);
      if (part.opacity) xml.attribute("opacity", *part.opacity);
      if (part.colour) xml.attribute("colour", fmt::format("#{:06x}", *part.colour));
      xml.close();
    }
    xml.close();
  }
  xml.close();
  write_file(looks_file(folder), xml.finish());
}

}  // namespace bodkin::scene
