#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "station/calibration_steps.h"
#include "station/real_time_check.h"
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
#include "core/utc_time.h"
#include "haptics/calibration.h"
#include "io/calibrations_file.h"

namespace bodkin::cli {

namespace {

using Json = nlohmann::ordered_json;
using station::CalibrationSettings;
using station::CalibrationStep;

struct DevicesCalibrateArguments {
  DeviceOptions device;
  std::vector<std::string> steps;
  std::string file;
  CalibrationSettings settings;
  bool show = false;
  bool forget = false;
  bool allow_late = false;
};

constexpr const char* devices_calibrate_footer = R"(Examples:
  bodkin devices calibrate force_dimension                       every step that the device allows
  bodkin devices calibrate openhaptics --steps workspace,tip     only these; earlier results stay
  bodkin devices calibrate haption --show                        the saved calibration
  bodkin devices calibrate haption --forget

Steps: workspace (the box that the hand can reach; its middle becomes the middle of the workspace), mounting (which
direction is away from you), tip (where the needle's tip is), axis (in which direction the needle points), weight (of
the handle: let go of it while the motors lift it by 25 mm), delay (of a force: hold the handle loosely while the motors
push it up and down with 1 N). Each step begins with the Enter key, or after a countdown if there is no terminal.
If the system may delay the motors' force, the force is kept below 1.5 N, and a note says so beforehand.
The result is saved in ~/.config/bodkin/calibrations.xml for this one device, and 'bodkin perform' uses it.)";

Json list_of(const Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Json json_of(const haptics::DeviceCalibration& calibration, const std::filesystem::path& file) {
  Json json = {{"file", file.string()},
               {"driver", calibration.driver},
               {"model", calibration.model},
               {"serial", calibration.serial},
               {"measured_at", calibration.measured_at}};
  if (calibration.reach) {
    json["reach_low_mm"] = list_of(calibration.reach->low);
    json["reach_high_mm"] = list_of(calibration.reach->high);
  }
  if (calibration.mounting) json["mounting_deg"] = *calibration.mounting / degree;
  if (calibration.tip_offset) {
    json["tip_offset_mm"] = list_of(*calibration.tip_offset);
    json["tip_residual_mm"] = calibration.tip_residual;
  }
  if (calibration.tool_axis) json["tool_axis"] = list_of(*calibration.tool_axis);
  if (calibration.weight) {
    json["weight_N"] = *calibration.weight;
    json["friction_N"] = calibration.friction.z();
    json["level_friction_N"] = {calibration.friction.x(), calibration.friction.y()};
  }
  if (calibration.delay) json["delay_s"] = *calibration.delay;
  return json;
}

// One line for each known property.
void print(const Console& console, const haptics::DeviceCalibration& calibration) {
  console.line(fmt::format("{}{}, calibrated {}", calibration.model,
                           calibration.serial.empty() ? "" : ", serial number " + calibration.serial,
                           calibration.measured_at));
  if (calibration.reach) {
    const Vec3 &low = calibration.reach->low, &high = calibration.reach->high;
    console.line(fmt::format("  workspace   x {:.0f} to {:.0f}, y {:.0f} to {:.0f}, z {:.0f} to {:.0f} mm", low.x(),
                             high.x(), low.y(), high.y(), low.z(), high.z()));
  }
  if (calibration.mounting) {
    console.line(fmt::format("  mounting    turned by {:.1f} degrees", *calibration.mounting / degree));
  }
  if (calibration.tip_offset) {
    const Vec3& tip = *calibration.tip_offset;
    console.line(fmt::format("  tip         {:.1f} {:.1f} {:.1f} mm, within {:.2f} mm", tip.x(), tip.y(), tip.z(),
                             calibration.tip_residual));
  }
  if (calibration.tool_axis) {
    const Vec3& axis = *calibration.tool_axis;
    console.line(fmt::format("  axis        {:.3f} {:.3f} {:.3f}", axis.x(), axis.y(), axis.z()));
  }
  if (calibration.weight) {
    const Vec3& friction = calibration.friction;
    console.line(fmt::format("  weight      {:.2f} N, friction {:.2f} N to the right, {:.2f} away, {:.2f} up",
                             *calibration.weight, friction.x(), friction.y(), friction.z()));
  }
  if (calibration.delay) console.line(fmt::format("  delay       {:.1f} ms", 1e3 * *calibration.delay));
}

std::vector<CalibrationStep> chosen_steps(const DevicesCalibrateArguments& arguments,
                                          const haptics::DeviceAbilities& device) {
  std::vector<CalibrationStep> possible = station::steps_for(device);
  if (arguments.steps.empty()) return possible;
  std::vector<CalibrationStep> steps;
  for (const std::string& name : arguments.steps) {
    const CalibrationStep step = station::calibration_step(name);
    if (std::find(possible.begin(), possible.end(), step) == possible.end()) {
      throw InputError(fmt::format(
          "--steps: '{}' needs a device that {}, which {} does not; leave it out", name,
          step == CalibrationStep::weight || step == CalibrationStep::delay ? "renders force" : "measures rotation",
          device.name));
    }
    steps.push_back(step);
  }
  return steps;
}

bool needs_force(const std::vector<CalibrationStep>& steps) {
  return std::any_of(steps.begin(), steps.end(), [](CalibrationStep step) {
    return step == CalibrationStep::weight || step == CalibrationStep::delay;
  });
}

haptics::DeviceCalibration measure(haptics::DevicePort port, const station::DeviceChoice& chosen,
                                   const haptics::DeviceAbilities& abilities,
                                   const DevicesCalibrateArguments& arguments, Console& console) {
  const std::vector<CalibrationStep> steps = chosen_steps(arguments, abilities);
  haptics::DeviceCalibration measured;
  const auto controller = std::make_shared<haptics::CalibrationController>();
  haptics::ServoSettings settings;
  settings.rate = std::clamp(abilities.rate, 200.0, 4000.0);
  const auto note = [&console](const std::string& sentence) { console.note(sentence); };
  if (needs_force(steps))
    settings.guard.user_force = station::measuring_force(chosen, abilities, arguments.allow_late, note);
  else
    settings.guard.user_force = 0.0;
  settings.guard.frozen_time = 0.0;  // a free handle can stand still under force
  const EndOnSignal signals;         // until the servo has ramped its force down
  haptics::DeviceServo servo(std::move(port), abilities, settings,
                             [controller](const haptics::ControlInput& input) { return controller->step(input); });
  servo.start();
  TerminalKeys keys;
  station::CalibrationSteps guide(servo, *controller, arguments.settings, calibration_person(console, keys));
  for (const CalibrationStep step : steps) guide.perform(step, measured);
  if (!servo.stop()) console.note("the device could not be stopped; switch it off and on again");
  return measured;
}

void show(const haptics::DeviceCalibration* known, const haptics::DeviceAbilities& device,
          const std::filesystem::path& file, const Console& console) {
  if (known == nullptr) {
    throw InputError(fmt::format("{} holds no calibration of {} {}; make one without --show or --forget",
                                 file.string(), device.name, device.serial));
  }
  print(console, *known);
  console.json(json_of(*known, file).dump(2));
}

std::filesystem::path file_of(const DevicesCalibrateArguments& arguments) {
  if (!arguments.file.empty()) return arguments.file;
  if (const auto file = io::calibrations_file()) return *file;
  throw InputError(
      "there is no folder for calibrations, because neither XDG_CONFIG_HOME nor HOME is an absolute path; give a "
      "--file");
}

void run_devices_calibrate(const DevicesCalibrateArguments& arguments, CommandContext& context) {
  Console console(context);
  const std::filesystem::path file = file_of(arguments);
  std::vector<haptics::DeviceCalibration> all = io::read_calibrations(file);
  const station::DeviceChoice chosen = choose_device(arguments.device);
  haptics::DevicePort port(*chosen.driver, chosen.identity, arguments.device.settings);
  haptics::DeviceAbilities abilities = port.abilities();
  station::complete_from_table(abilities);
  const auto known = [&] { return io::find_calibration(all, chosen.driver->name, abilities.name, abilities.serial); };
  if (arguments.show) return show(known(), abilities, file, console);
  if (arguments.forget) {
    show(known(), abilities, file, console);
    const auto index = known() - all.data();
    all.erase(all.begin() + index);
    io::write_calibrations(all, file);
    console.note("forgotten");
    return;
  }
  haptics::DeviceCalibration measured;
  try {
    measured = measure(std::move(port), chosen, abilities, arguments, console);
  } catch (const station::CalibrationCancelled&) {
    console.clear_bar();
    console.note("the calibration was interrupted; nothing was saved");
    context.exit_code = 128 + EndOnSignal::signal();
    return;
  }
  measured.driver = chosen.driver->name;
  measured.model = abilities.name;
  measured.serial = abilities.serial;
  measured.measured_at = utc_now();
  io::merge_calibration(all, measured);
  io::write_calibrations(all, file);
  print(console, *known());
  console.line(fmt::format("kept in {}", file.string()));
  console.json(json_of(*known(), file).dump(2));
}

}  // namespace

void add_devices_calibrate_command(CLI::App& devices_group, CommandContext& context) {
  add_command(devices_group, "calibrate",
              "Calibrate a device: workspace, mounting, tip, axis, weight of the handle, delay of the force",
              devices_calibrate_footer, [&context](CLI::App& command) {
                auto arguments = std::make_shared<DevicesCalibrateArguments>();
                add_text(command, "DEVICE", arguments->device.device,
                         "DRIVER or DRIVER:IDENTITY, as 'devices list' prints it")
                    .required();
                add_driver_settings(command, arguments->device);
                add_texts(command, "--steps", arguments->steps,
                          "workspace, mounting, tip, axis, weight, delay (default: all possible)")
                    .separated_by_commas("STEPS");
                add_number(command, "--seconds", arguments->settings.seconds, 1.0, 600.0,
                           "Longest time for the motions of a step, s, 1 to 600; Enter ends it earlier");
                add_number(command, "--countdown", arguments->settings.countdown, 0.0, 600.0,
                           "Time before each step if there is no terminal, s, 0 to 600");
                add_text(command, "--file", arguments->file, "File to save the calibration in").without_default();
                add_switch(
                    command, "--allow-late", arguments->allow_late,
                    "Weigh with up to 4 N without real-time priority, although the system may then delay the servo");
                add_switch(command, "--show", arguments->show, "Measure nothing; print the saved calibration");
                add_switch(command, "--forget", arguments->forget, "Measure nothing; remove the saved calibration");
                on_run(command, [arguments, &context] { run_devices_calibrate(*arguments, context); });
              });
}

}  // namespace bodkin::cli
