#include "app/models/attempt_options.h"

#include <algorithm>

#include "app/models/late_force.h"
#include "link/tracking_driver.h"
#include "session/left_needles.h"
#include "station/recorded_hand.h"
#include "station/ultrasound_request.h"
#include "tracking/tool_driver.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/parameter_value.h"
#include "haptics/drivers/drivers.h"
#include "haptics/plugin.h"
#include "io/force_choice.h"
#include "io/placement_file.h"

namespace bodkin::app {

namespace {

const bodkin_driver& driver_called(const std::string& name) {
  if (name.find('/') != std::string::npos) return haptics::load_plugin(name);
  for (const bodkin_driver* driver :
       {&station::recorded_driver(), &link::tracking_driver(), &tracking::tool_driver()})
    if (name == driver->name) return *driver;
  const auto drivers = haptics::built_in_drivers();
  const auto found =
      std::find_if(drivers.begin(), drivers.end(), [&](const bodkin_driver* driver) { return name == driver->name; });
  if (found == drivers.end()) throw InputError(fmt::format("there is no driver '{}'", name));
  return **found;
}

station::DeviceChoice device_of(const nlohmann::json& words) {
  return {&driver_called(words.at("driver").get<std::string>()), words.at("identity").get<std::string>(),
          words.at("settings").get<std::string>()};
}

}  // namespace

void AttemptOptions::apply(station::StationOptions& station) const {
  anatomy::HapticSettings& haptics = station.patient.description.haptics;
  if (!resistance.empty()) haptics.resistance = io::parse_resistance(resistance, "--resistance");
  if (!constraint.empty()) haptics.constraint = io::parse_constraint(constraint, "--constraint");
  if (!parts.empty()) haptics.parts = io::parse_parts(parts, "--part");
  if (mechanics) haptics.mechanics = *mechanics;
  if (force_in_organs) haptics.force_in_organs = *force_in_organs;
  if (device.driver != nullptr) station.device = device;
  station.second = second;
  station.moving_body = moving_body;
  station.mannequin = mannequin;
  station.scale = scale;
  station.force_scale = force_scale;
  station.allow_late = allow_late || late_force_is_allowed();
  station.use_calibration = use_calibration;
  station.longest = longest;
}

std::filesystem::path AttemptOptions::file_of(int attempt) const {
  if (attempt == 0) return output;
  std::filesystem::path file;
  for (int number = attempt + 1; file.empty() || std::filesystem::exists(file); ++number) {
    file = output.parent_path() / fmt::format("{}-{}{}", output.stem().string(), number, output.extension().string());
  }
  return file;
}

AttemptOptions read_attempt_options(const std::string& text) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    AttemptOptions options;
    options.resistance = json.value("resistance", options.resistance);
    options.constraint = json.value("constraint", options.constraint);
    options.parts = json.value("parts", options.parts);
    // `bodkin perform` has already refused invalid values.
    if (anatomy::Mechanics value{}; parse_value(json.value("mechanics", std::string()), value))
      options.mechanics = value;
    if (anatomy::ForceInOrgans value{}; parse_value(json.value("force_in_organs", std::string()), value))
      options.force_in_organs = value;
    options.scale = json.value("scale", options.scale);
    options.force_scale = json.value("force_scale", options.force_scale);
    options.allow_late = json.value("allow_late", options.allow_late);
    options.use_calibration = json.value("use_calibration", options.use_calibration);
    options.output = json.value("output", std::string());
    options.overwrite = json.value("overwrite", options.overwrite);
    options.longest = json.value("longest_s", options.longest);
    if (json.contains("device")) options.device = device_of(json.at("device"));
    if (json.contains("second")) {
      const auto role = session::second_role(json.at("second_as").get<std::string>());
      options.second =
          station::SecondChoice{device_of(json.at("second")), role.value_or(session::SecondRole::plunger)};
    }
    if (json.contains("moving_body_mm")) {
      fem::ProbeFace face;
      face.width = json.at("moving_body_mm").at(0).get<double>();
      face.thickness = json.at("moving_body_mm").at(1).get<double>();
      face.radius = json.at("moving_body_mm").at(2).get<double>();
      options.moving_body = face;
    }
    for (const nlohmann::json& line : json.value("left_needles_mm", nlohmann::json::array())) {
      if (const auto left = session::parse_left_needles(line.get<std::string>()))
        options.left_needles.insert(options.left_needles.end(), left->begin(), left->end());
    }
    if (json.contains("mannequin")) {
      const bool at_hub = json.value("at_hub", false);
      options.mannequin = {
          io::read_rigid_placement(json.at("mannequin").get<std::string>(), "register without --scale"), at_hub};
    }
    if (json.contains("ultrasound")) {
      options.ultrasound =
          station::choose_ultrasound(station::ultrasound_request(json.at("ultrasound").get<std::string>()));
    }
    return options;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("--attempt is not valid JSON that describes an attempt: {}", error.what()));
  }
}

}  // namespace bodkin::app
