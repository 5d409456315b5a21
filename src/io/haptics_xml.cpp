#include "io/haptics_xml.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "anatomy/case.h"
#include "io/haptics_attributes.h"
#include "io/xml_document.h"

namespace bodkin {

namespace {

constexpr std::size_t most_relaxations = 4;
constexpr double shortest_up = 1e-6;      // a shorter vector has no direction worth the name
constexpr double unit_tolerance = 1e-12;  // closer to 1 is a unit vector already, and stays what it is

// Takes an attribute where there is one, and leaves the default where there is none.
struct TakeAttribute {
  const XmlElement& element;

  void operator()(const char* name, double& value) const { value = element.number(name, value); }
  void operator()(const char* name, bool& value) const { value = element.boolean(name, value); }
  void operator()(const char* name, LayeredLaw& value) const {
    value = element.string(name) == "sum" ? LayeredLaw::sum : LayeredLaw::cubic;
  }
  void operator()(const char* name, ProxyVariant& value) const {
    value = element.string(name) == "viscous" ? ProxyVariant::viscous : ProxyVariant::drag;
  }
  void operator()(const char* name, NeedleHold& value) const {
    value = element.string(name) == "pinned" ? NeedleHold::pinned : NeedleHold::clamped;
  }
};

template <typename Settings>
Settings taken(const XmlElement& element, Settings settings = {}) {
  each_attribute(settings, TakeAttribute{element});
  return settings;
}

// What one value of an element means for another: throws unless `value` is at most `bound`.
void require_at_most(const XmlElement& element, const std::string& origin, const char* name, double value,
                     const char* bound_name, double bound) {
  if (value <= bound) return;
  fail_at(origin, element.line,
          fmt::format("{} {} is {}, expected at most the {} of {}", element.name, name, value, bound_name, bound));
}

// Children that must come in rising order of one of their attributes.
void require_rising(const XmlElement& element, const std::string& origin, const char* name, double value,
                    double before) {
  if (value > before) return;
  fail_at(origin, element.line,
          fmt::format("{} {} is {}, expected more than the {} of the one before", element.name, name, value, before));
}

// What a model holds beside its attributes, and what must hold between them.
template <typename Settings>
void complete(Settings&, const XmlElement&, const std::string&) {}

void complete(TrackingWallSettings& settings, const XmlElement& element, const std::string& origin) {
  for (const XmlElement& child : element.children) {
    const auto layer = taken<TrackingWallDepthLayer>(child);
    if (settings.layers.empty() && layer.from != 0.0) {
      fail_at(origin, child.line, fmt::format("layer from_mm is {}, expected 0 for the first layer", layer.from));
    }
    if (!settings.layers.empty()) require_rising(child, origin, "from_mm", layer.from, settings.layers.back().from);
    settings.layers.push_back(layer);
  }
}

void complete(DepthProfileSettings& settings, const XmlElement& element, const std::string& origin) {
  require_at_most(element, origin, "trailing_mm", settings.trailing, "puncture_depth_mm", settings.puncture_depth);
}

void complete(VolumeProxySettings& settings, const XmlElement& element, const std::string& origin) {
  constexpr double least_window = 1.0;  // HU
  require_at_most(element, origin, "gradient_least_per_mm", settings.gradient_least, "gradient_reference_per_mm",
                  settings.gradient_reference);
  if (settings.field.highest_hounsfield < settings.field.lowest_hounsfield + least_window) {
    fail_at(
        origin, element.line,
        fmt::format("volume_proxy field_highest_HU is {}, expected at least {} more than the field_lowest_HU of {}",
                    settings.field.highest_hounsfield, least_window, settings.field.lowest_hounsfield));
  }
  for (const XmlElement& child : element.children) {
    const auto point = taken<TransferPoint>(child);
    if (!settings.transfer.empty())
      require_rising(child, origin, "value", point.value, settings.transfer.back().value);
    settings.transfer.push_back(point);
  }
}

void complete(ThreeComponentSettings& settings, const XmlElement& element, const std::string& origin) {
  if (const XmlElement* inwards = element.child("inwards"); inwards != nullptr)
    settings.inwards = taken(*inwards, settings.inwards);
  if (const XmlElement* outwards = element.child("outwards"); outwards != nullptr)
    settings.outwards = taken(*outwards, settings.outwards);
  require_at_most(element, origin, "cutting_force_N", settings.cutting_force, "puncture_force_N",
                  settings.puncture_force);
  if (settings.linear == 0.0 && settings.quadratic == 0.0) {
    fail_at(origin, element.line,
            "three_component linear_N_per_mm and quadratic_N_per_mm2 are both 0, expected one of them above 0");
  }
}

void complete(NeedleGraspSettings& settings, const XmlElement& element, const std::string& origin) {
  require_at_most(element, origin, "two_way", settings.two_way, "one_way", settings.one_way);
}

template <typename Settings>
Settings model_from(const XmlElement& element, const std::string& origin) {
  auto settings = taken<Settings>(element);
  complete(settings, element, origin);
  return settings;
}

// The alternative of a variant that bears the element's name.
template <typename Models, std::size_t... Index>
Models chosen(const XmlElement& element, const std::string& origin, const auto& names,
              std::index_sequence<Index...>) {
  Models models;
  const auto attempt = [&]<std::size_t I>() {
    if (names[I] == element.name) models = model_from<std::variant_alternative_t<I, Models>>(element, origin);
  };
  (attempt.template operator()<Index>(), ...);
  return models;
}

template <typename Models>
Models model_of(const XmlElement& parent, const std::string& origin, const auto& names) {
  return chosen<Models>(parent.children.front(), origin, names,
                        std::make_index_sequence<std::variant_size_v<Models>>());
}

template <typename Part>
void take_once(std::optional<Part>& part, const XmlElement& element, const std::string& origin) {
  if (part) {
    fail_at(origin, element.line,
            fmt::format("<parts> has the element <{}> once more, expected it once at most", element.name));
  }
  part = model_from<Part>(element, origin);
}

ForceParts read_parts(const XmlElement& element, const std::string& origin) {
  ForceParts parts;
  double sum = 0.0;
  for (const XmlElement& child : element.children) {
    if (child.name == "shaft_friction") {
      take_once(parts.shaft_friction, child, origin);
    } else if (child.name == "needle_grasp") {
      take_once(parts.needle_grasp, child, origin);
    } else {
      parts.relaxation.push_back(model_from<PronyTerm>(child, origin));
      sum += parts.relaxation.back().share;
      if (parts.relaxation.size() > most_relaxations) {
        fail_at(
            origin, child.line,
            fmt::format("<parts> has more than {0} elements <relaxation>, expected {0} at most", most_relaxations));
      }
      if (sum > 1.0) {
        fail_at(origin, child.line,
                fmt::format("relaxation share brings the sum of the shares to {}, expected at most 1", sum));
      }
    }
  }
  return parts;
}

Vec3 up_of(const XmlElement& element, const std::string& origin) {
  constexpr const char* names[] = {"up_x", "up_y", "up_z"};
  const auto given = std::count_if(std::begin(names), std::end(names),
                                   [&](const char* name) { return element.find(name) != nullptr; });
  if (given == 0) return GravitySettings{}.up;
  if (given != 3) {
    fail_at(origin, element.line,
            fmt::format("compensation has {} of up_x, up_y and up_z, expected all three or none", given));
  }
  const Vec3 up(element.number(names[0], 0.0), element.number(names[1], 0.0), element.number(names[2], 0.0));
  const double length = up.norm();
  if (length < shortest_up) {
    fail_at(origin, element.line,
            fmt::format("compensation up_x, up_y and up_z are {}, {} and {}, expected a direction, which is longer "
                        "than {}",
                        up.x(), up.y(), up.z(), shortest_up));
  }
  return std::abs(length - 1.0) <= unit_tolerance ? up : Vec3(up / length);
}

}  // namespace

HapticSettings read_haptics(const XmlElement& element, const std::string& origin) {
  HapticSettings haptics;
  haptics.rate = element.number("rate_Hz", haptics.rate);
  if (const XmlElement* resistance = element.child("resistance"); resistance != nullptr)
    haptics.resistance = model_of<ResistanceSettings>(*resistance, origin, resistance_names);
  if (const XmlElement* constraint = element.child("constraint"); constraint != nullptr)
    haptics.constraint = model_of<ConstraintSettings>(*constraint, origin, constraint_names);
  if (const XmlElement* parts = element.child("parts"); parts != nullptr) haptics.parts = read_parts(*parts, origin);
  if (const XmlElement* compensation = element.child("compensation"); compensation != nullptr) {
    haptics.compensation = taken<GravitySettings>(*compensation);
    haptics.compensation.up = up_of(*compensation, origin);
  }
  return haptics;
}

HapticSettings parse_haptics_xml(std::string_view document, const std::string& origin, const XmlSchema& schema) {
  return read_haptics(schema.read(document, origin, {.root = "haptics"}), origin);
}

}  // namespace bodkin
