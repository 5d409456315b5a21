#include "anatomy/case.h"
#include "io/haptics_attributes.h"
#include "io/haptics_xml.h"
#include "io/xml_writer.h"

namespace bodkin {

namespace {

constexpr const char* up_names[3] = {"up_x", "up_y", "up_z"};

struct GiveAttribute {
  XmlWriter& xml;

  void operator()(const char* name, double value) const { xml.attribute(name, value); }
  void operator()(const char* name, bool value) const { xml.attribute(name, value); }
  void operator()(const char* name, LayeredLaw value) const {
    xml.attribute(name, value == LayeredLaw::sum ? "sum" : "cubic");
  }
  void operator()(const char* name, ProxyVariant value) const {
    xml.attribute(name, value == ProxyVariant::viscous ? "viscous" : "drag");
  }
  void operator()(const char* name, NeedleHold value) const {
    xml.attribute(name, value == NeedleHold::pinned ? "pinned" : "clamped");
  }
};

template <typename Settings>
void write(XmlWriter& xml, std::string_view element, Settings settings);

// What a model holds beside its attributes.
template <typename Settings>
void write_inside(XmlWriter&, const Settings&) {}

void write_inside(XmlWriter& xml, const TrackingWallSettings& settings) {
  for (const TrackingWallDepthLayer& layer : settings.layers) write(xml, "layer", layer);
}

void write_inside(XmlWriter& xml, const VolumeProxySettings& settings) {
  for (const TransferPoint& point : settings.transfer) write(xml, "transfer_point", point);
}

void write_inside(XmlWriter& xml, const ThreeComponentSettings& settings) {
  write(xml, "inwards", settings.inwards);
  write(xml, "outwards", settings.outwards);
}

template <typename Settings>
void write(XmlWriter& xml, std::string_view element, Settings settings) {
  xml.open(std::string(element));
  each_attribute(settings, GiveAttribute{xml});
  write_inside(xml, settings);
  xml.close();
}

void write_parts(XmlWriter& xml, const ForceParts& parts) {
  if (parts.relaxation.empty() && !parts.shaft_friction && !parts.needle_grasp) return;
  xml.open("parts");
  for (const PronyTerm& term : parts.relaxation) write(xml, "relaxation", term);
  if (parts.shaft_friction) write(xml, "shaft_friction", *parts.shaft_friction);
  if (parts.needle_grasp) write(xml, "needle_grasp", *parts.needle_grasp);
  xml.close();
}

}  // namespace

void write_haptics(XmlWriter& xml, const HapticSettings& haptics) {
  const auto write_model = [&xml](const char* role, const auto& models) {
    xml.open(role);
    std::visit([&](const auto& settings) { write(xml, name_of(models), settings); }, models);
    xml.close();
  };
  xml.open("haptics");
  xml.attribute("rate_Hz", haptics.rate);
  write_model("resistance", haptics.resistance);
  write_model("constraint", haptics.constraint);
  write_parts(xml, haptics.parts);
  xml.open("compensation");
  GravitySettings compensation = haptics.compensation;
  each_attribute(compensation, GiveAttribute{xml});
  xml.coordinates(up_names, compensation.up);
  xml.close();
  xml.close();
}

std::string haptics_xml(const HapticSettings& haptics) {
  XmlWriter xml;
  write_haptics(xml, haptics);
  return xml.finish();
}

}  // namespace bodkin
