#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "desktop/mouse_window.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_options.h"
#include "haptics/device_servo.h"

namespace bodkin::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::chrono::milliseconds check_interval{10};
constexpr double least_success = 0.99;  // of the rounds must be on time
constexpr int exit_not_ready = 3;

struct DevicesCheckArguments {
  DeviceOptions device;
  double seconds = 10.0;
};

constexpr const char* devices_check_footer = R"(Examples:
  bodkin devices check force_dimension              the first device of that driver, for ten seconds
  bodkin devices check openhaptics:Left --seconds 30
  bodkin devices check ./my_driver.so               a driver of your own

No force is ever asked for. Move the device while it is being checked: to every corner, and press its buttons.
Exit code 0: it is ready. 3: it is not, and the last line says why.)";

// What was seen of the device.
struct Observation {
  double seconds = 0.0;
  std::uint64_t rounds = 0;
  haptics::ServoTimings timings;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());  // mm, operator's frame
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
  std::uint32_t buttons = 0;  // that were pressed
  double hottest = 0.0;
  double released = 0.0;  // s without a hand, if the device can detect it
  haptics::DeviceFault fault = haptics::DeviceFault::none;
  std::string sentence;
  double strongest = 0.0;  // N that left; must be 0
  bool answered = true;    // it let itself be stopped

  double rate() const { return static_cast<double>(rounds) / seconds; }
};

// `window`: may be null.
Observation observe(haptics::DeviceServo& servo, double seconds, desktop::MouseWindow* window, Console& console) {
  Observation seen;
  const Progress progress = console.progress();
  servo.start();
  for (const std::string& sentence : servo.refused()) console.note(sentence);
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  while (elapsed() < seconds) {
    std::this_thread::sleep_for(check_interval);
    if (progress) progress("checking: move the device to every corner, press its buttons", elapsed() / seconds);
    if (servo.rounds() == 0) continue;
    if (window != nullptr) {
      window->poll();
      desktop::WindowScene scene;
      scene.time = elapsed();
      scene.state = "checking";
      window->show(scene);
    }
    const haptics::ServoSnapshot& now = servo.tick().snapshot();
    if (now.device.fault != haptics::DeviceFault::none) {
      if (seen.fault == haptics::DeviceFault::none) seen.sentence = servo.explain();
      seen.fault = now.device.fault;
      continue;
    }
    if (now.device.ended()) break;
    seen.low = seen.low.cwiseMin(now.device.hand.translation());
    seen.high = seen.high.cwiseMax(now.device.hand.translation());
    seen.buttons |= now.device.buttons;
    seen.hottest = std::max(seen.hottest, now.device.temperature);
    seen.strongest = std::max(seen.strongest, now.applied.force.norm());
    if (!now.device.held) seen.released += std::chrono::duration<double>(check_interval).count();
  }
  seen.seconds = elapsed();
  seen.rounds = servo.rounds();
  seen.timings = servo.tick().timings();
  seen.answered = servo.stop();
  console.clear_bar();
  return seen;
}

// Empty when the device is ready; else what stands against it.
std::string obstacle(const Observation& seen, const haptics::DeviceAbilities& abilities) {
  if (seen.fault != haptics::DeviceFault::none) {
    return seen.sentence.empty() ? fmt::format("the device reported a fault: {}", haptics::text_of(seen.fault))
                                 : seen.sentence;
  }
  if (seen.rounds == 0) return "the device did not answer once; is it switched on?";
  if (!seen.answered) return "the device did not let itself be stopped; switch it off and on again";
  if (seen.rate() < 0.9 * abilities.rate) {
    return fmt::format("{:.0f} rounds a second instead of {:.0f}; close other programs, or use a lower rate",
                       seen.rate(), abilities.rate);
  }
  const double late = seen.timings.ticks == 0
                          ? 0.0
                          : static_cast<double>(seen.timings.overruns) / static_cast<double>(seen.timings.ticks);
  if (1.0 - late < least_success) {
    return fmt::format(
        "{:.1f} % of the rounds were late; close other programs, and permit real-time priority (docs/perform.md)",
        100.0 * late);
  }
  return "";
}

std::string box_text(const Vec3& low, const Vec3& high) {
  return fmt::format("x {:.0f} to {:.0f}, y {:.0f} to {:.0f}, z {:.0f} to {:.0f} mm", low.x(), high.x(), low.y(),
                     high.y(), low.z(), high.z());
}

std::string known(double value, const char* unit) {
  return value > 0.0 ? fmt::format("{:.4g} {}", value, unit) : "not known";
}

void say_abilities(const Console& console, const haptics::DeviceAbilities& device) {
  console.line(fmt::format("{}{}", device.name, device.serial.empty() ? "" : ", serial number " + device.serial));
  console.line(device.peak_force > 0.0
                   ? fmt::format("  force       {} peak, {} continuous, torque {}", known(device.peak_force, "N"),
                                 known(device.continuous_force, "N"),
                                 device.peak_torque > 0.0 ? known(device.peak_torque, "N mm") : "none")
                   : "  force       none: it only measures where the hand is");
  console.line(fmt::format("  stiffness   {}, resolution {}", known(device.stiffness, "N/mm"),
                           known(device.resolution, "mm")));
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

Json json_of(const Observation& seen, const haptics::DeviceAbilities& device, const std::string& why_not) {
  Json json = {{"ready", why_not.empty()},
               {"name", device.name},
               {"serial", device.serial},
               {"peak_force_N", device.peak_force},
               {"continuous_force_N", device.continuous_force},
               {"peak_torque_N_mm", device.peak_torque},
               {"stiffness_N_per_mm", device.stiffness},
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
  Console console(context);
  const station::DeviceChoice chosen = choose_device(arguments.device);
  const auto window = is_mouse(chosen) ? std::make_unique<desktop::MouseWindow>("check of the mouse") : nullptr;
  haptics::DevicePort port(*chosen.driver, chosen.identity, arguments.device.settings);
  haptics::DeviceAbilities abilities = port.abilities();
  station::complete_from_table(abilities);
  haptics::ServoSettings settings;
  settings.rate = std::clamp(abilities.rate, 200.0, 4000.0);
  haptics::DeviceServo servo(std::move(port), abilities, settings,
                             [](const haptics::ControlInput&) { return haptics::Control{}; });
  say_abilities(console, abilities);
  const Observation seen = observe(servo, arguments.seconds, window.get(), console);
  const std::string why_not = obstacle(seen, abilities);
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
  console.json(json_of(seen, abilities, why_not).dump(2));
  return why_not.empty() ? 0 : exit_not_ready;
}

}  // namespace

void add_devices_check_command(CLI::App& devices_group, CommandContext& context) {
  auto arguments = std::make_shared<DevicesCheckArguments>();
  CLI::App* command = add_command(
      devices_group, "check", "Open a device, ask it for nothing, and say how well it answers", devices_check_footer);
  add_text(*command, "DEVICE", arguments->device.device, "DRIVER or DRIVER:IDENTITY, as 'devices list' prints it")
      .required();
  add_driver_settings(*command, arguments->device);
  add_number(*command, "--seconds", arguments->seconds, 0.1, 3600.0, "s for which it is checked, 0.1 to 3600");
  on_run(*command, [arguments, &context] { context.exit_code = run_devices_check(*arguments, context); });
}

}  // namespace bodkin::cli
