#include "cli/devices_protocol.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "station/calibration_steps.h"
#include "station/device_protocol.h"
#include "station/real_time_check.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/utsname.h>

#include "cli/console.h"
#include "cli/end_on_signal.h"
#include "cli/terminal_keys.h"
#include "core/error.h"
#include "core/files.h"
#include "core/utc_time.h"
#include "haptics/calibration_controller.h"
#include "haptics/deadline_clock.h"
#include "haptics/device_servo.h"
#include "haptics/stable_stiffness.h"

namespace bodkin::cli {

namespace {

using Json = nlohmann::ordered_json;
using station::CalibrationStep;
using station::ProtocolFinding;

constexpr int protocol_version = 1;

Json numbers_of(const Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Json json_of_device(const haptics::DeviceAbilities& device, double rate) {
  return {{"name", device.name},
          {"serial", device.serial},
          {"peak_force_N", device.peak_force},
          {"continuous_force_N", device.continuous_force},
          {"peak_torque_N_mm", device.peak_torque},
          {"stiffness_N_per_mm", device.stiffness},
          {"offered_stiffness_N_per_mm", haptics::stable_stiffness(device, rate).weakest()},
          {"damping_N_s_per_mm", device.damping},
          {"resolution_mm", device.resolution},
          {"rate_Hz", device.rate},
          {"delay_s", device.delay},
          {"delay_source", device.delay_source},
          {"workspace_low_mm", numbers_of(device.workspace_low)},
          {"workspace_high_mm", numbers_of(device.workspace_high)},
          {"measures_rotation", device.measures_rotation},
          {"has_dead_man", device.has_dead_man},
          {"owns_loop", device.owns_loop}};
}

Json json_of_finding(const ProtocolFinding& found) {
  Json faults = Json::array();
  for (const station::ProtocolFault& fault : found.faults) {
    faults.push_back({{"at_s", fault.at}, {"fault", haptics::text_of(fault.fault)}, {"sentence", fault.sentence}});
  }
  return {{"step", found.name},
          {"seconds", found.seconds},
          {"rounds", found.rounds},
          {"from_mm", numbers_of(found.from)},
          {"to_mm", numbers_of(found.to)},
          {"low_mm", numbers_of(found.low)},
          {"high_mm", numbers_of(found.high)},
          {"spread_mm", numbers_of(found.spread)},
          {"smallest_change_mm", numbers_of(found.smallest)},
          {"axis_from", numbers_of(found.axis_from)},
          {"axis_to", numbers_of(found.axis_to)},
          {"buttons", found.buttons},
          {"released_s", found.released},
          {"hottest_motor", found.hottest},
          {"strongest_force_N", found.strongest},
          {"faults", faults},
          {"against", found.against}};
}

Json json_of_system() {
  Json json = {{"real_time_refused", haptics::real_time_refusals()}};
  utsname names{};
  if (uname(&names) == 0) {
    json["system"] = names.sysname;
    json["release"] = names.release;
    json["machine"] = names.machine;
  }
  return json;
}

// Waits for Enter in a terminal; otherwise a step begins at once and lasts its time.
class EnterKey {
 public:
  bool is_there() const noexcept { return keys_.are_there(); }
  bool pressed() {
    bool found = false;
    while (const std::optional<char> key = keys_.next()) found = found || *key == '\n' || *key == '\r';
    return found;
  }

 private:
  TerminalKeys keys_;
};

void require_no_signal() {
  if (EndOnSignal::signal() != 0) throw station::CalibrationCancelled();
}

// The steps in which the motors push, by 1 N and by the handle's weight; what cannot be measured is a sentence.
Json measure_force(haptics::DeviceServo& servo, haptics::CalibrationController& controller, Console& console,
                   EnterKey& enter, double seconds) {
  station::CalibrationPerson person;
  person.report = [&](const std::string& sentence) { console.line(sentence); };
  person.progress = console.progress();
  person.after_measurement = [&] { console.clear_bar(); };
  if (enter.is_there()) person.confirmed = [&enter] { return enter.pressed(); };
  person.cancelled = [] { return EndOnSignal::signal() != 0; };
  station::CalibrationSettings settings;
  settings.seconds = std::max(1.0, seconds);
  station::CalibrationSteps steps(servo, controller, settings, std::move(person));
  haptics::DeviceCalibration measured;
  Json json = Json::object();
  for (const CalibrationStep step : {CalibrationStep::weight, CalibrationStep::delay}) {
    const std::string name(station::name_of(step));
    try {
      steps.perform(step, measured);
    } catch (const std::runtime_error& error) {
      json[name + "_against"] = error.what();
      console.line(fmt::format("  {:<11} {}", name, error.what()));
    }
  }
  if (measured.weight) {
    json["weight_N"] = *measured.weight;
    json["friction_N"] = measured.friction.z();
    json["level_friction_N"] = {measured.friction.x(), measured.friction.y()};
  }
  if (measured.delay) json["delay_s"] = *measured.delay;
  return json;
}

// Leads through the steps and adds the results to `json`. Returns the number of failed steps. Throws
// station::CalibrationCancelled when a signal ends the command.
int perform_steps(haptics::DeviceServo& servo, haptics::CalibrationController& controller,
                  const haptics::DeviceAbilities& abilities, const ProtocolOptions& options, Console& console,
                  Json& json) {
  EnterKey enter;
  if (enter.is_there()) console.line("press Enter to begin each step, and to end it early");
  int against = 0;
  for (const station::ProtocolStep& step : station::protocol_steps(abilities)) {
    // The last step may leave a device that must be restarted.
    if (step.name == station::last_protocol_step && abilities.peak_force > 0.0 && !options.without_force) {
      json["force"] = measure_force(servo, controller, console, enter, options.seconds);
    }
    console.line(fmt::format("{}: {}", step.name, step.task));
    while (enter.is_there() && !enter.pressed()) {
      require_no_signal();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    const auto continues = [&](double) { return !enter.pressed() && EndOnSignal::signal() == 0; };
    const ProtocolFinding found = station::observe_step(servo, abilities, step, options.seconds, continues);
    require_no_signal();
    if (!found.against.empty()) {
      ++against;
      console.line(fmt::format("  {:<11} {}", step.name, found.against));
    }
    json["steps"].push_back(json_of_finding(found));
  }
  return against;
}

}  // namespace

int run_device_protocol(const DeviceOptions& device, const ProtocolOptions& options, const CommandContext& context) {
  Console console(context);
  const station::DeviceChoice chosen = choose_device(device);
  haptics::DevicePort port(*chosen.driver, chosen.identity, device.settings);
  haptics::DeviceAbilities abilities = port.abilities();
  station::complete_from_table(abilities);
  haptics::ServoSettings settings;
  settings.rate = std::clamp(abilities.rate, 200.0, 4000.0);
  const auto note = [&console](const std::string& sentence) { console.note(sentence); };
  if (options.without_force)
    settings.guard.user_force = 0.0;
  else
    settings.guard.user_force = station::measuring_force(chosen, abilities, options.allow_late, note);
  settings.guard.frozen_time = 0.0;  // a handle that is left alone may stand still
  const auto controller = std::make_shared<haptics::CalibrationController>();
  const EndOnSignal signals;  // until the servo has ramped its force down
  haptics::DeviceServo servo(std::move(port), abilities, settings,
                             [controller](const haptics::ControlInput& input) { return controller->step(input); });
  Json json = {{"protocol", protocol_version},
               {"bodkin", BODKIN_VERSION},
               {"made_at", utc_now()},
               {"driver", chosen.driver->name},
               {"settings", device.settings},
               {"computer", json_of_system()},
               {"device", json_of_device(abilities, settings.rate)},
               {"steps", Json::array()}};
  servo.start();
  int against = 0;
  try {
    against = perform_steps(servo, *controller, abilities, options, console, json);
  } catch (const station::CalibrationCancelled&) {
    servo.stop();
    console.clear_bar();
    console.note("the protocol was interrupted; nothing was written");
    return 128 + EndOnSignal::signal();
  }
  const haptics::ServoTimings& timings = servo.tick().timings();
  json["loop"] = {{"rounds", servo.rounds()},
                  {"overruns", timings.overruns},
                  {"lateness_p99_s", timings.lateness.percentile(0.99)},
                  {"longest_lateness_s", timings.lateness.maximum()},
                  {"tick_p99_s", timings.compute.percentile(0.99)}};
  json["answered_the_stop"] = servo.stop();
  write_file(options.file, json.dump(2) + "\n");
  console.line(fmt::format("{} of {} steps failed; the results of all of them are in {}", against,
                           json["steps"].size(), options.file.string()));
  console.json(json.dump(2));
  return 0;
}

}  // namespace bodkin::cli
