#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_options.h"
#include "cli/force_options.h"
#include "cli/keys.h"
#include "cli/outcome.h"
#include "core/error.h"
#include "io/case_folder.h"
#include "training/hand_session.h"

namespace bodkin {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds look{100};

struct Arguments {
  std::string folder;
  DeviceOptions device;
  std::string output = "session-by-hand.bodkin";
  bool overwrite = false;
  double longest = 600.0;    // s
  double scale = 1.0;        // mm of the needle per mm of the hand
  double force_scale = 1.0;  // N at the hand per N of the needle
  ForceOptions forces;
};

constexpr const char* footer = R"(Examples:
  bodkin perform patient openhaptics                      the first Touch that is connected
  bodkin perform patient spacemouse                       no force at the hand: it is shown
  bodkin perform patient force_dimension --force-scale 0.5
  bodkin perform patient ./my_driver.so -o mine.bodkin

The patient lies prone, the head away from you, the skin below the middle of the workspace. Keys: space holds the
needle where it is and takes it up again; c presses and releases the clutch; a arms after a fault; d takes the force
away; q ends. 'bodkin devices check' first shows whether the device is well.)";

std::atomic<bool> asked_to_end{false};

// Ctrl-C ends the session as q does.
class EndOnSignal {
 public:
  EndOnSignal() : interrupt_(std::signal(SIGINT, &end)), terminate_(std::signal(SIGTERM, &end)) {}
  ~EndOnSignal() {
    std::signal(SIGINT, interrupt_);
    std::signal(SIGTERM, terminate_);
  }
  EndOnSignal(const EndOnSignal&) = delete;
  EndOnSignal& operator=(const EndOnSignal&) = delete;

 private:
  static void end(int) { asked_to_end.store(true); }
  void (*interrupt_)(int);
  void (*terminate_)(int);
};

std::string text_of_event(const GuardEvent& event) {
  std::string text(text_of(event.reason));
  if (event.cause != GuardReason::none) text += fmt::format(": {}", text_of(event.cause));
  if (event.device_fault != DeviceFault::none) text += fmt::format(": {}", text_of(event.device_fault));
  return text;
}

// What the person sees ten times a second.
std::string screen(const ServoSnapshot& servo, const HandMoment& moment, const TissueLibrary& library) {
  const TickOutput& now = moment.output;
  const double force = now.requested.force.norm();
  const auto bar = static_cast<std::size_t>(std::clamp(std::lround(2.0 * force), 0L, 20L));
  const char* const hold = servo.frozen ? ", held" : servo.clutched ? ", clutch" : "";
  return fmt::format("{}{}  {:5.1f} mm  {:5.2f} N [{:<20}] {}", text_of(servo.state), hold, now.depth, force,
                     std::string(bar, '='), library.title(now.tissue));
}

void obey(char key, ServoTick& servo) {
  using Kind = ServoCommand::Kind;
  const ServoSnapshot now = servo.snapshot();
  const auto tell = [&servo](Kind kind) {
    ServoCommand command;
    command.kind = kind;
    servo.command(command);
  };
  if (key == ' ') tell(now.frozen ? Kind::unfreeze : Kind::freeze);
  if (key == 'c') tell(now.clutched ? Kind::unclutch : Kind::clutch);
  if (key == 'a') tell(Kind::arm);
  if (key == 'd') tell(Kind::disarm);
  if (key == 'q') asked_to_end.store(true);
}

// Until the person or the time ends it, or the disk refuses.
RunResult perform(HandSession& session, const Arguments& arguments, const TissueLibrary& library, Console& console) {
  RunResult result;
  Keys keys;
  const EndOnSignal signals;
  asked_to_end.store(false);
  const Progress progress = console.progress();
  session.start();
  ServoTick& servo = session.servo().tick();
  obey('a', servo);
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  while (!asked_to_end.load() && !session.failed() && elapsed() < arguments.longest) {
    std::this_thread::sleep_for(look);
    while (const std::optional<char> key = keys.next()) obey(*key, servo);
    GuardEvent event;
    while (servo.next_event(event)) {
      if (event.reason == GuardReason::slew) continue;  // every puncture has one
      console.clear_bar();
      console.note(fmt::format("{:.1f} s: {}", event.time, text_of_event(event)));
    }
    if (progress) progress(screen(servo.snapshot(), session.moment(), library), elapsed() / arguments.longest);
  }
  result.operator_finished = asked_to_end.load();
  if (!session.finish()) {
    result.notes.emplace_back("the device did not let itself be stopped; switch it off and on again");
  }
  result.wall_time = elapsed();
  result.ticks = session.moment().ticks;
  const ServoTimings& timings = servo.timings();
  result.missed_deadlines = timings.overruns;
  result.worst_lateness = timings.lateness.maximum();
  result.records_lost = session.records_lost();
  for (const std::string& sentence : session.servo().refused()) result.notes.push_back(sentence);
  console.clear_bar();
  return result;
}

// The case's ticks are the device's ticks.
void require_same_rate(const DeviceAbilities& device, double rate) {
  if (!device.owns_loop || std::abs(device.rate - rate) <= 0.01 * rate) return;
  throw InputError(fmt::format(
      "the device runs at {:g} Hz and the case at {:g} Hz; set rate_Hz of the case's haptics to the device's",
      device.rate, rate));
}

void run(const Arguments& arguments, const CommandContext& context) {
  Console console(context);
  require_writable(arguments.output, "--output");
  const ChosenDevice chosen = choose_device(arguments.device);
  Case patient = load_case(arguments.folder, console.progress());
  apply(arguments.forces, patient.description.haptics);
  if (!patient.description.procedure.path) {
    throw InputError(
        fmt::format("{}: the case has no planned path, so there is no place to put the hand; make the "
                    "case with --entry and --target",
                    arguments.folder));
  }
  DevicePort port(*chosen.driver, chosen.identity, arguments.device.settings);
  DeviceAbilities device = port.abilities();
  complete_from_table(device);
  require_same_rate(device, patient.description.haptics.rate);
  patient.description.device = limits_of(device, patient.description.device);
  DeviceLimits& limits = patient.description.device;  // of what the needle's side may ask for
  limits.stiffness /= arguments.scale * arguments.force_scale;
  limits.peak_force /= arguments.force_scale;
  limits.continuous_force /= arguments.force_scale;
  limits.peak_torque /= arguments.force_scale;
  const NeedlePath path = *patient.description.procedure.path;
  ServoSettings settings;
  settings.rate = patient.description.haptics.rate;
  settings.workspace = workspace_about(path);
  settings.workspace.scale = arguments.scale;
  settings.workspace.force_scale = arguments.force_scale;
  SessionHeader header = session_header(patient, arguments.folder, path);
  header.operator_name = "hand";
  header.operator_settings = nlohmann::ordered_json{
      {"device", device.name},
      {"driver", chosen.driver->name},
      {"scale", arguments.scale},
      {"force_scale",
       arguments.force_scale}}.dump();
  header.device = limits;
  const Case whole = patient;
  HandSession session(std::move(patient), header, arguments.output, arguments.overwrite, std::move(port), device,
                      settings);
  RunResult result = perform(session, arguments, whole.library, console);
  if (result.ticks == 0) throw SystemError("the device did not answer once; is it switched on?");
  const double rate = static_cast<double>(result.ticks) / result.wall_time;
  if (std::abs(rate - settings.rate) > 0.05 * settings.rate) {
    console.note(
        fmt::format("the device ran at {:.0f} Hz instead of {:g}; the tissue's time was {:.2f} times the clock's",
                    rate, settings.rate, rate / settings.rate));
  }
  const Outcome outcome = read_outcome(arguments.output, whole, std::move(result));
  for (const std::string& note : outcome.run.notes) console.note(note);
  console.note(fmt::format("{} of {} ticks were late (by {:.2f} ms at worst)", outcome.run.missed_deadlines,
                           outcome.run.ticks, 1e3 * outcome.run.worst_lateness));
  print(console, outcome, whole);
  console.json(json_of(outcome, whole).dump(2));
}

}  // namespace

void add_perform_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = add_command(app, "perform", "Your own hand performs the procedure on a haptic device", footer);
  add_text(*command, "CASE", arguments->folder, "Folder of the case").required();
  add_text(*command, "DEVICE", arguments->device.device, "DRIVER or DRIVER:IDENTITY, as 'devices list' prints it")
      .required();
  add_driver_settings(*command, arguments->device);
  add_text(*command, "-o,--output", arguments->output, "Session file");
  add_switch(*command, "--overwrite", arguments->overwrite, "Replace the session file if it exists");
  add_number(*command, "--scale", arguments->scale, 0.1, 10.0, "mm of the needle per mm of the hand, 0.1 to 10");
  add_number(*command, "--force-scale", arguments->force_scale, 0.01, 1.0,
             "N at the hand per N of the needle, for weak devices; recorded, never scored; 0.01 to 1");
  add_number(*command, "--max-time", arguments->longest, 1.0, 3600.0, "s after which it ends, 1 to 3600");
  add_force_options(*command, arguments->forces);
  on_run(*command, [arguments, &context] { run(*arguments, context); });
}

}  // namespace bodkin
