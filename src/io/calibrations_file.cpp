#include "io/calibrations_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

#include "core/files.h"
#include "io/resources.h"
#include "io/xml_document.h"
#include "io/xml_writer.h"

namespace bodkin::io {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_calibrations_file = 1 << 20;  // bytes
constexpr const char* low_names[3] = {"low_x_mm", "low_y_mm", "low_z_mm"};
constexpr const char* high_names[3] = {"high_x_mm", "high_y_mm", "high_z_mm"};
constexpr const char* offset_names[3] = {"x_mm", "y_mm", "z_mm"};
constexpr const char* axis_names[3] = {"x", "y", "z"};
constexpr const char* friction_names[3] = {"friction_x_N", "friction_y_N", "friction_N"};
constexpr double unit_slack = 1e-6;

Vec3 vector_of(const XmlElement& element, const char* const (&names)[3]) {
  return {element.number(names[0], 0.0), element.number(names[1], 0.0), element.number(names[2], 0.0)};
}

bool same_device(const haptics::DeviceCalibration& calibration, std::string_view driver, std::string_view model,
                 std::string_view serial) {
  return calibration.driver == driver && calibration.model == model && calibration.serial == serial;
}

haptics::DeviceCalibration calibration_from(const XmlElement& element, const std::string& origin) {
  haptics::DeviceCalibration found;
  found.driver = element.string("driver");
  found.model = element.string("model");
  found.serial = element.string("serial");
  found.measured_at = element.string("measured_at");
  if (const XmlElement* reach = element.child("reach")) {
    found.reach = {vector_of(*reach, low_names), vector_of(*reach, high_names)};
    const double side = (found.reach->high - found.reach->low).minCoeff();
    if (!(side > 0.0)) {
      fail_at(origin, reach->line,
              fmt::format("the smallest side of the reach is {} mm, expected more than 0", side));
    }
  }
  if (const XmlElement* mounting = element.child("mounting")) {
    found.mounting = mounting->number("turn_deg", 0.0) * degree;
  }
  if (const XmlElement* tip = element.child("tip")) {
    found.tip_offset = vector_of(*tip, offset_names);
    found.tip_residual = tip->number("residual_mm", 0.0);
  }
  if (const XmlElement* axis = element.child("axis")) {
    found.tool_axis = vector_of(*axis, axis_names);
    const double length = found.tool_axis->norm();
    if (std::abs(length - 1.0) > unit_slack) {
      fail_at(origin, axis->line, fmt::format("the axis has the length {}, expected 1", length));
    }
  }
  if (const XmlElement* weight = element.child("weight")) {
    found.weight = weight->number("N", 0.0);
    found.friction = vector_of(*weight, friction_names);
  }
  if (const XmlElement* delay = element.child("delay")) found.delay = delay->number("s", 0.0);
  return found;
}

void write(XmlWriter& xml, const haptics::DeviceCalibration& calibration) {
  xml.open("device");
  xml.attribute("driver", calibration.driver);
  xml.attribute("model", calibration.model);
  xml.optional("serial", calibration.serial);
  xml.attribute("measured_at", calibration.measured_at);
  if (calibration.reach) {
    xml.open("reach");
    xml.coordinates(low_names, calibration.reach->low);
    xml.coordinates(high_names, calibration.reach->high);
    xml.close();
  }
  if (calibration.mounting) {
    xml.open("mounting");
    xml.attribute("turn_deg", *calibration.mounting / degree);
    xml.close();
  }
  if (calibration.tip_offset) {
    xml.open("tip");
    xml.coordinates(offset_names, *calibration.tip_offset);
    xml.attribute("residual_mm", calibration.tip_residual);
    xml.close();
  }
  if (calibration.tool_axis) {
    xml.open("axis");
    xml.coordinates(axis_names, *calibration.tool_axis);
    xml.close();
  }
  if (calibration.weight) {
    xml.open("weight");
    xml.attribute("N", *calibration.weight);
    xml.coordinates(friction_names, calibration.friction);
    xml.close();
  }
  if (calibration.delay) {
    xml.open("delay");
    xml.attribute("s", *calibration.delay);
    xml.close();
  }
  xml.close();
}

}  // namespace

std::optional<fs::path> calibrations_file() {
  for (const auto& [variable, below] : {std::pair("XDG_CONFIG_HOME", ""), std::pair("HOME", ".config")}) {
    const char* const value = std::getenv(variable);
    if (value != nullptr && fs::path(value).is_absolute()) return fs::path(value) / below / "bodkin/calibrations.xml";
  }
  return std::nullopt;
}

std::vector<haptics::DeviceCalibration> parse_calibrations(std::string_view document, const std::string& origin) {
  const XmlElement root = XmlSchema("calibrations.xsd").read(document, origin, {.root = "calibrations"});
  std::vector<haptics::DeviceCalibration> found;
  for (const XmlElement& element : root.children) {
    haptics::DeviceCalibration next = calibration_from(element, origin);
    if (find_calibration(found, next.driver, next.model, next.serial) != nullptr) {
      fail_at(origin, element.line,
              fmt::format("a second calibration of {} {} {}, expected one of every device", next.driver, next.model,
                          next.serial));
    }
    found.push_back(std::move(next));
  }
  return found;
}

std::vector<haptics::DeviceCalibration> read_calibrations(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  return parse_calibrations(read_text_file(file, largest_calibrations_file), file.string());
}

std::string calibrations_xml(std::span<const haptics::DeviceCalibration> calibrations) {
  XmlWriter xml;
  xml.open("calibrations");
  xml.attribute("version", 1);
  for (const haptics::DeviceCalibration& calibration : calibrations) write(xml, calibration);
  xml.close();
  return xml.finish();
}

void write_calibrations(std::span<const haptics::DeviceCalibration> calibrations, const fs::path& file) {
  const std::string text = calibrations_xml(calibrations);
  parse_calibrations(text, file.string());  // values that could not be read back must not be written
  write_file(file, text);
}

const haptics::DeviceCalibration* find_calibration(std::span<const haptics::DeviceCalibration> calibrations,
                                                   std::string_view driver, std::string_view model,
                                                   std::string_view serial) {
  const auto found = std::find_if(
      calibrations.begin(), calibrations.end(),
      [&](const haptics::DeviceCalibration& calibration) { return same_device(calibration, driver, model, serial); });
  return found == calibrations.end() ? nullptr : &*found;
}

void merge_calibration(std::vector<haptics::DeviceCalibration>& calibrations,
                       const haptics::DeviceCalibration& measured) {
  const auto found =
      std::find_if(calibrations.begin(), calibrations.end(), [&](const haptics::DeviceCalibration& calibration) {
        return same_device(calibration, measured.driver, measured.model, measured.serial);
      });
  if (found == calibrations.end()) {
    calibrations.push_back(measured);
    return;
  }
  found->measured_at = measured.measured_at;
  if (measured.reach) found->reach = measured.reach;
  if (measured.mounting) found->mounting = measured.mounting;
  if (measured.tip_offset) {
    found->tip_offset = measured.tip_offset;
    found->tip_residual = measured.tip_residual;
  }
  if (measured.tool_axis) found->tool_axis = measured.tool_axis;
  if (measured.weight) {
    found->weight = measured.weight;
    found->friction = measured.friction;
  }
  if (measured.delay) found->delay = measured.delay;
}

}  // namespace bodkin::io
