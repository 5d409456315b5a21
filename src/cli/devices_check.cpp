#include <algorithm>
#include <memory>
#include <string>

#include "station/device_check.h"
#include "station/station_checks.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_options.h"
#include "cli/devices_protocol.h"
#include "haptics/device_servo.h"
#include "haptics/stable_stiffness.h"

namespace bodkin::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr int exit_not_ready = 3;

struct DevicesCheckArguments {
  DeviceOptions device;
  double seconds = 10.0;
  std::string protocol;  // file to write, "" = none
  bool without_force = false;
  bool allow_late = false;
};

constexpr const char* devices_check_footer = R"(Examples:
  bodkin devices check force_dimension              the first device of that driver, for ten seconds
  bodkin devices check openhaptics:Left --seconds 30
  bodkin devices check ./my_driver.so               a driver of your own

  bodkin devices check haption --protocol haption.json      a full test of a device in ten minutes

No force is rendered. During the check, move the device to every corner and press its buttons.
Exit code 0: the device is ready. 3: it is not, and the last line says why.
--protocol says step by step what to do (where to move, which buttons to press, when to let go) and writes the
measurements to the file, which you can send to us. Unless --without-force is given, its last steps weigh the handle and push it with 1 N.
If the system may delay the motors' force, the force is then kept below 1.5 N, and a note says so beforehand.)";

std::string box_text(const Vec3& low, const Vec3& high) {
  return fmt::format("x {:.0f} to {:.0f}, y {:.0f} to {:.0f}, z {:.0f} to {:.0f} mm", low.x(), high.x(), low.y(),
                     high.y(), low.z(), high.z());
}

std::string known(double value, const char* unit) {
  return value > 0.0 ? fmt::format("{:.4g} {}", value, unit) : "not known";
}

double rate_of(const haptics::DeviceAbilities& device) {
  return std::clamp(device.rate, 200.0, 4000.0);
}

std::string source_of_delay(const haptics::DeviceAbilities& device) {
  if (device.measured_delay) return "as 'devices calibrate' has measured it";
  return device.delay_source.empty() ? "the vendor states none; 'devices calibrate' measures it"
                                     : device.delay_source;
}

void say_abilities(const Console& console, const haptics::DeviceAbilities& device,
                   const haptics::StableStiffness& stiffness) {
  console.line(fmt::format("{}{}", device.name, device.serial.empty() ? "" : ", serial number " + device.serial));
  console.line(device.peak_force > 0.0
                   ? fmt::format("  force       {} peak, {} continuous, torque {}", known(device.peak_force, "N"),
                                 known(device.continuous_force, "N"),
                                 device.peak_torque > 0.0 ? known(device.peak_torque, "N mm") : "none")
                   : "  force       none: it only measures where the hand is");
  console.line(
      fmt::format("  stiffness   {}{}, resolution {}", known(device.stiffness, "N/mm"),
                  stiffness.is_cut() ? fmt::format(", of which {}", station::remaining_stiffness(stiffness)) : "",
                  known(device.resolution, "mm")));
  if (device.peak_force > 0.0) {
    console.line(fmt::format("  delay       {:.1f} ms from a tick to the force: {:.2g} ms of the device ({}){}",
                             1e3 * stiffness.delay, 1e3 * device.measured_delay.value_or(device.delay),
                             source_of_delay(device),
                             device.owns_loop ? "" : " and one tick until our loop sends it"));
  }
  if (device.workspace_low != device.workspace_high) {
    console.line("  workspace   " + box_text(device.workspace_low, device.workspace_high));
  }
}

void say_times(const Console& console, const char* what, const haptics::LatencyHistogram& times) {
  console.line(fmt::format("  {:<11} median {:.1f}, 99 % within {:.1f}, longest {:.1f} us", what,
                           1e6 * times.percentile(0.5), 1e6 * times.percentile(0.99), 1e6 * times.maximum()));
}

Json times_json(const haptics::LatencyHistogram& times) {
  return {{"median_s", times.percentile(0.5)},
          {"p99_s", times.percentile(0.99)},
          {"p999_s", times.percentile(0.999)},
          {"longest_s", times.maximum()}};
}

Json json_of(const station::DeviceObservation& seen, const haptics::DeviceAbilities& device,
             const haptics::StableStiffness& offered, const std::string& why_not) {
  Json json = {{"ready", why_not.empty()},
               {"name", device.name},
               {"serial", device.serial},
               {"peak_force_N", device.peak_force},
               {"continuous_force_N", device.continuous_force},
               {"peak_torque_N_mm", device.peak_torque},
               {"stiffness_N_per_mm", device.stiffness},
               {"offered_stiffness_N_per_mm", offered.weakest()},
               {"offered_by_axis_N_per_mm", {offered.axis.x(), offered.axis.y(), offered.axis.z()}},
               {"delay_s", device.measured_delay.value_or(device.delay)},
               {"delay_source", source_of_delay(device)},
               {"seconds", seen.seconds},
               {"rounds", seen.rounds},
               {"rate_Hz", seen.rate()},
               {"lateness", times_json(seen.timings.lateness)},
               {"tick", times_json(seen.timings.compute)},
               {"overruns", seen.timings.overruns},
               {"buttons_pressed", seen.buttons},
               {"hottest_motor", seen.hottest},
               {"strongest_force_N", seen.strongest}};
  if (seen.low.x() <= seen.high.x()) {
    json["reached_low_mm"] = {seen.low.x(), seen.low.y(), seen.low.z()};
    json["reached_high_mm"] = {seen.high.x(), seen.high.y(), seen.high.z()};
  }
  if (!why_not.empty()) json["why_not"] = why_not;
  return json;
}

int run_devices_check(const DevicesCheckArguments& arguments, const CommandContext& context) {
  if (!arguments.protocol.empty()) {
    require_writable(arguments.protocol, "--protocol");
    return run_device_protocol(arguments.device,
                               {arguments.protocol, arguments.seconds, arguments.without_force, arguments.allow_late},
                               context);
  }
  Console console(context);
  const station::DeviceChoice chosen = choose_device(arguments.device);
  haptics::DevicePort port(*chosen.driver, chosen.identity, arguments.device.settings);
  haptics::DeviceAbilities abilities = port.abilities();
  station::complete_from_table(abilities);
  const haptics::DeviceCalibration known = station::calibration_of(chosen, abilities);
  if (known.delay) abilities.measured_delay = known.delay;
  const haptics::StableStiffness stiffness = haptics::stable_stiffness(abilities, rate_of(abilities), known.friction);
  haptics::ServoSettings settings;
  settings.rate = rate_of(abilities);
  haptics::DeviceServo servo(std::move(port), abilities, settings,
                             [](const haptics::ControlInput&) { return haptics::Control{}; });
  say_abilities(console, abilities, stiffness);
  const Progress progress = console.progress();
  const auto watch = [&](double elapsed) {
    if (progress)
      progress("checking: move the device to every corner, press its buttons", elapsed / arguments.seconds);
    return true;
  };
  const station::DeviceObservation seen = station::observe_device(servo, arguments.seconds, watch);
  console.clear_bar();
  for (const std::string& sentence : servo.refused()) console.note(sentence);
  const std::string why_not = station::why_not_ready(seen, abilities);
  console.line(fmt::format("  rounds      {} in {:.1f} s, {:.0f} a second, {} too late", seen.rounds, seen.seconds,
                           seen.rate(), seen.timings.overruns));
  say_times(console, "lateness", seen.timings.lateness);
  say_times(console, "tick", seen.timings.compute);
  if (seen.low.x() <= seen.high.x()) console.line("  reached     " + box_text(seen.low, seen.high));
  std::string buttons;
  for (int button = 0; button < 32; ++button) {
    if ((seen.buttons >> button & 1U) != 0) buttons += fmt::format(" {}", button);
  }
  console.line(fmt::format("  buttons    {}", buttons.empty() ? " none was pressed" : buttons));
  if (abilities.has_dead_man) console.line(fmt::format("  dead-man    released for {:.1f} s", seen.released));
  console.line(why_not.empty() ? "ready" : "not ready: " + why_not);
  console.json(json_of(seen, abilities, stiffness, why_not).dump(2));
  return why_not.empty() ? 0 : exit_not_ready;
}

}  // namespace

void add_devices_check_command(CLI::App& devices_group, CommandContext& context) {
  add_command(devices_group, "check", "Open a device without rendering a force, and report how well it answers",
              devices_check_footer, [&context](CLI::App& command) {
                auto arguments = std::make_shared<DevicesCheckArguments>();
                add_text(command, "DEVICE", arguments->device.device,
                         "DRIVER or DRIVER:IDENTITY, as 'devices list' prints it")
                    .required();
                add_driver_settings(command, arguments->device);
                add_number(command, "--seconds", arguments->seconds, 0.1, 3600.0,
                           "Duration of the check, or with --protocol of each step, s, 0.1 to 3600");
                add_text(command, "--protocol", arguments->protocol,
                         "Ask for one motion after the other and write the results to this JSON file")
                    .without_default();
                add_switch(command, "--without-force", arguments->without_force,
                           "With --protocol: leave out the steps in which the motors push");
                add_switch(command, "--allow-late", arguments->allow_late,
                           "With --protocol: allow up to 4 N without real-time priority, although the system may "
                           "then delay the servo");
                on_run(command,
                       [arguments, &context] { context.exit_code = run_devices_check(*arguments, context); });
              });
}

}  // namespace bodkin::cli
