#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "station/calibration_steps.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/calibration_person.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_options.h"
#include "cli/end_on_signal.h"
#include "cli/terminal_keys.h"
#include "core/error.h"
#include "core/files.h"

namespace bodkin::cli {

namespace {

using Json = nlohmann::ordered_json;

struct DevicesTouchArguments {
  DeviceOptions device;
  std::vector<std::string> points;
  std::string output = "touched.csv";
  double countdown = 3.0;  // s
  bool no_calibration = false;
};

constexpr const char* devices_touch_footer = R"(Examples:
  bodkin devices touch openhaptics --points left,right,hole -o touched.csv
  bodkin register mannequin.csv touched.csv --target 0,60,20 -o placed.json
  bodkin perform patient openhaptics --mannequin placed.json

Touch at least three points, not on a line, whose places in the patient are known (mannequin.csv:
"left,12.5,80,-31"): beads, marks, or the hole of a mock table, in which the needle may turn. The motors stay off. Each point begins with the Enter key,
or after a countdown if there is no terminal. The tip must have been calibrated before ('bodkin devices calibrate DEVICE
--steps tip,axis'). docs/calibrate.md explains the whole procedure.)";

void check_names(const std::vector<std::string>& names) {
  constexpr std::size_t least = 3, longest = 40;
  if (names.size() < least)
    throw InputError(
        fmt::format("--points: {} names, expected three or more, as --points left,right,hole", names.size()));
  for (const std::string& name : names) {
    const bool is_plain = !name.empty() && name.size() <= longest && name.front() != '#' &&
                          name.find_first_of(",\"\r\n") == std::string::npos;
    if (!is_plain)
      throw InputError(fmt::format("--points: '{}' is not a name, expected up to {} letters without a comma",
                                   name.substr(0, longest), longest));
    if (std::count(names.begin(), names.end(), name) > 1)
      throw InputError(fmt::format("--points: '{}' is given twice, expected each name once", name));
  }
}

Vec3 tip_offset(const DevicesTouchArguments& arguments, const station::DeviceChoice& chosen,
                const haptics::DeviceAbilities& abilities) {
  if (arguments.no_calibration) return Vec3::Zero();
  const haptics::DeviceCalibration known = station::calibration_of(chosen, abilities);
  if (known.tip_offset) return *known.tip_offset;
  throw InputError(
      fmt::format("the tip of {} was not calibrated; run 'bodkin devices calibrate {} --steps tip,axis', "
                  "or take the device's own point with --no-calibration",
                  abilities.name, arguments.device.device));
}

void run_devices_touch(const DevicesTouchArguments& arguments, CommandContext& context) {
  check_names(arguments.points);
  require_writable(arguments.output, "--output");
  Console console(context);
  const station::DeviceChoice chosen = choose_device(arguments.device);
  haptics::DevicePort port(*chosen.driver, chosen.identity, arguments.device.settings);
  const haptics::DeviceAbilities abilities = port.abilities();
  const Vec3 offset = tip_offset(arguments, chosen, abilities);
  const auto controller = std::make_shared<haptics::CalibrationController>();
  haptics::ServoSettings settings;
  settings.rate = std::clamp(abilities.rate, 200.0, 4000.0);
  settings.guard.user_force = 0.0;
  std::string csv = "name,x,y,z\n";
  Json touched = Json::array();
  try {
    const EndOnSignal signals;
    haptics::DeviceServo servo(std::move(port), abilities, settings,
                               [controller](const haptics::ControlInput& input) { return controller->step(input); });
    servo.start();
    TerminalKeys keys;
    station::CalibrationSettings pace;
    pace.countdown = arguments.countdown;
    station::CalibrationSteps guide(servo, *controller, pace, calibration_person(console, keys));
    for (const std::string& name : arguments.points) {
      const haptics::TouchFit fit = guide.touch(name, offset);
      csv += fmt::format("{},{:.4f},{:.4f},{:.4f}\n", name, fit.place.x(), fit.place.y(), fit.place.z());
      touched.push_back(
          {{"name", name}, {"place_mm", {fit.place.x(), fit.place.y(), fit.place.z()}}, {"spread_mm", fit.spread}});
    }
    if (!servo.stop()) console.note("the device could not be stopped; switch it off and on again");
  } catch (const station::CalibrationCancelled&) {
    console.clear_bar();
    console.note("it was interrupted; nothing was written");
    context.exit_code = 128 + EndOnSignal::signal();
    return;
  }
  write_file(arguments.output, csv);
  console.line(fmt::format("{} points are in {}; next: bodkin register MANNEQUIN.csv {} -o placed.json",
                           arguments.points.size(), arguments.output, arguments.output));
  console.json(Json{{"file", arguments.output}, {"device", abilities.name}, {"points", touched}}.dump(2));
}

}  // namespace

void add_devices_touch_command(CLI::App& devices_group, CommandContext& context) {
  add_command(devices_group, "touch", "Touch points of a mannequin with the tip, to register the device to it",
              devices_touch_footer, [&context](CLI::App& command) {
                auto arguments = std::make_shared<DevicesTouchArguments>();
                add_text(command, "DEVICE", arguments->device.device,
                         "DRIVER or DRIVER:IDENTITY, as 'devices list' prints it")
                    .required();
                add_driver_settings(command, arguments->device);
                add_texts(command, "--points", arguments->points,
                          "Names of the points, in the order in which they are touched")
                    .separated_by_commas("NAMES")
                    .required();
                add_text(command, "-o,--output", arguments->output,
                         "File of points: name,x,y,z in mm, as the device stands");
                add_number(command, "--countdown", arguments->countdown, 0.0, 600.0,
                           "Time before each point if there is no terminal, s, 0 to 600");
                add_switch(command, "--no-calibration", arguments->no_calibration,
                           "Take the point that the device reports for the tip");
                on_run(command, [arguments, &context] { run_devices_touch(*arguments, context); });
              });
}

}  // namespace bodkin::cli
