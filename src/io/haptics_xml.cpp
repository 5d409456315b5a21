#include "io/haptics_xml.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "anatomy/case.h"
#include "io/settings_xml.h"

namespace bodkin::io {

namespace {

constexpr double shortest_up = 1e-6;      // a shorter vector has no meaningful direction
constexpr double unit_tolerance = 1e-12;  // closer to 1 is a unit vector already, and is not changed

// The alternative of a variant with the element's name.
template <typename... Models>
void read_model(std::variant<Models...>& model, const XmlElement& element, const std::string& origin) {
  const auto attempt = [&]<typename Settings>(Settings* /*of*/) {
    if (Settings::element != element.name) return;
    if constexpr (std::is_same_v<Settings, anatomy::RegisteredSettings>)
      model = Settings(anatomy::registered_from(tree_of(element)));
    else
      model = settings_from<Settings>(element, origin);
  };
  (attempt(static_cast<Models*>(nullptr)), ...);
}

anatomy::GravitySettings compensation_from(const XmlElement& element, const std::string& origin) {
  auto compensation = settings_from<anatomy::GravitySettings>(element, origin);
  Vec3& up = compensation.up;
  const double length = up.norm();
  if (length < shortest_up) {
    fail_at(origin, element.line,
            fmt::format("compensation up_x, up_y and up_z are {}, {} and {}, expected a direction, which is longer "
                        "than {}",
                        up.x(), up.y(), up.z(), shortest_up));
  }
  if (std::abs(length - 1.0) > unit_tolerance) up = Vec3(up / length);
  return compensation;
}

}  // namespace

anatomy::HapticSettings read_haptics(const XmlElement& element, const std::string& origin) {
  anatomy::HapticSettings haptics;
  haptics.rate = element.number("rate_Hz", haptics.rate);
  if (const std::string* mechanics = element.find("mechanics"); mechanics != nullptr)
    parse_value(*mechanics, haptics.mechanics);
  if (const std::string* in_organs = element.find("force_in_organs"); in_organs != nullptr)
    parse_value(*in_organs, haptics.force_in_organs);
  if (const XmlElement* resistance = element.child("resistance"); resistance != nullptr)
    read_model(haptics.resistance, resistance->children.front(), origin);
  if (const XmlElement* constraint = element.child("constraint"); constraint != nullptr)
    read_model(haptics.constraint, constraint->children.front(), origin);
  if (const XmlElement* parts = element.child("parts"); parts != nullptr)
    haptics.parts = settings_from<anatomy::ForceParts>(*parts, origin);
  if (const XmlElement* compensation = element.child("compensation"); compensation != nullptr)
    haptics.compensation = compensation_from(*compensation, origin);
  return haptics;
}

anatomy::HapticSettings parse_haptics_xml(std::string_view document, const std::string& origin,
                                          const XmlSchema& schema) {
  return read_haptics(schema.read(document, origin, {.root = "haptics"}), origin);
}

SettingsTree haptics_tree(const anatomy::HapticSettings& haptics) {
  const auto model_tree = [](const char* role, const auto& models) {
    SettingsTree tree{.name = role};
    std::visit(
        [&](const auto& settings) {
          tree.children.push_back(settings_tree(std::string(anatomy::name_of(models)), settings));
        },
        models);
    return tree;
  };
  SettingsTree tree = settings_tree("haptics", haptics);
  tree.children.push_back(model_tree("resistance", haptics.resistance));
  tree.children.push_back(model_tree("constraint", haptics.constraint));
  if (SettingsTree parts = settings_tree("parts", haptics.parts); !parts.children.empty())
    tree.children.push_back(std::move(parts));
  tree.children.push_back(settings_tree("compensation", haptics.compensation));
  return tree;
}

void write_haptics(XmlWriter& xml, const anatomy::HapticSettings& haptics) {
  write_settings(xml, haptics_tree(haptics));
}

std::string haptics_xml(const anatomy::HapticSettings& haptics) {
  XmlWriter xml;
  write_haptics(xml, haptics);
  return xml.finish();
}

}  // namespace bodkin::io
