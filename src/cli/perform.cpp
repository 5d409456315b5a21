#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "desktop/body_view.h"
#include "desktop/keys.h"
#include "desktop/mouse_window.h"
#include "patient/prepared_body.h"
#include "station/corridor_keeper.h"
#include "station/hand_session.h"
#include "station/recorded_hand.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/device_options.h"
#include "cli/force_options.h"
#include "cli/moving_patient.h"
#include "cli/outcome.h"
#include "cli/pane_options.h"
#include "cli/second_device.h"
#include "core/error.h"
#include "haptics/calibration.h"
#include "io/calibrations_file.h"
#include "io/case_folder.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds look_interval{100};
constexpr std::chrono::milliseconds quick_look_interval{4};  // with a window, whose pointer must not wait

struct PerformArguments {
  std::string folder;
  DeviceOptions device;
  std::string output = "session-by-hand.bodkin";
  bool overwrite = false;
  double longest = 600.0;    // s
  double scale = 1.0;        // mm of the needle per mm of the hand
  double force_scale = 1.0;  // N at the hand per N of the needle
  bool no_calibration = false;
  SecondOptions second;
  ForceOptions forces;
  std::string body;        // "": static
  std::string ultrasound;  // "": none
};

constexpr const char* perform_footer = R"(Examples:
  bodkin perform patient openhaptics                      the first Touch that is connected
  bodkin perform patient spacemouse                       no force at the hand: it is shown
  bodkin perform patient mouse                            mouse and keyboard, in a window that shows the force
  bodkin perform patient simulated                        no hand at all: a simulated one
  bodkin perform patient recorded:mine.bodkin             the hand of a session
  bodkin perform patient force_dimension --force-scale 0.5
  bodkin perform patient ./my_driver.so -o mine.bodkin
  bodkin perform patient mouse --ultrasound C5-2 --resistance embedded_needle      what a probe sees of it, live
  bodkin perform patient force_dimension:104 --second openhaptics                  the other hand on the plunger
  bodkin perform patient force_dimension:104 --second force_dimension:105 --second-as probe
  bodkin perform patient simulated --second openhaptics --second-as probe --resistance embedded_needle --body moving

The patient lies prone, the head away from you, the skin below the middle of the workspace. Keys: space holds the
needle where it is and takes it up again; c presses and releases the clutch; a arms after a fault; d takes the force
away, both for a second hand too; q ends. 'bodkin devices check' first shows whether the device is well.)";

// Whether the devices render any.
struct HasForce {
  bool first = false;
  bool second = false;
};

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

// What the window of the mouse shows.
WindowScene scene_of(const ServoSnapshot& servo, const HandMoment& moment, const Case& patient, double time,
                     const std::string& message) {
  const NeedlePath& path = *patient.description.procedure.path;
  const Vec3 way = path.direction(), from_entry = servo.needle.translation() - path.entry;
  WindowScene scene;
  scene.time = time;
  scene.force = moment.output.requested.force.norm();
  scene.depth = moment.output.depth;
  scene.tissue = patient.library.title(moment.output.tissue);
  scene.state = text_of(servo.state);
  scene.hold = servo.frozen ? "held" : servo.clutched ? "clutch" : "";
  scene.message = moment.corridor_left ? "the deformable body is not prepared here: draw the needle back" : message;
  scene.beside = (from_entry - way * way.dot(from_entry)).norm();
  scene.angle = std::acos(std::clamp(way.dot(needle_axis(servo.needle)), -1.0, 1.0)) * 180.0 / std::numbers::pi;
  scene.needle = moment.needle;
  scene.needle.translation() -= moment.needle_ahead;
  scene.armed = servo.state != GuardState::disarmed;
  scene.faulted = servo.state == GuardState::faulted;
  return scene;
}

// What the person sees ten times a second.
std::string screen(const ServoSnapshot& servo, const HandMoment& moment, const TissueLibrary& library) {
  const TickOutput& now = moment.output;
  const double force = now.requested.force.norm();
  const auto bar = static_cast<std::size_t>(std::clamp(std::lround(2.0 * force), 0L, 20L));
  const char* const hold = servo.frozen ? ", held" : servo.clutched ? ", clutch" : "";
  const char* const place = moment.corridor_left ? ", NOT PREPARED HERE, draw back" : "";
  return fmt::format("{}{}  {:5.1f} mm  {:5.2f} N [{:<20}] {}{}", text_of(servo.state), hold, now.depth, force,
                     std::string(bar, '='), library.title(now.tissue), place);
}

// `second`: may be null.
void obey(char key, ServoTick& servo, SecondHand* second) {
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
  if (key == 'a' && second != nullptr) second->arm();
  if (key == 'd' && second != nullptr) second->disarm();
  if (key == 'q') asked_to_end.store(true);
}

// Says what a guard did since the last time; the newest sentence goes to `said`. `whose`: how a sentence begins.
void tell_events(ServoTick& servo, bool has_force, const char* whose, std::string& said, Console& console) {
  GuardEvent event;
  while (servo.next_event(event)) {
    // Every puncture has the one, every release the other.
    if (event.reason == GuardReason::slew || event.reason == GuardReason::passivity) continue;
    const bool peak = event.reason == GuardReason::peak || event.reason == GuardReason::torque_peak;
    if (peak && !has_force) continue;  // of a device whose peak is nothing
    said = fmt::format("{:.1f} s: {}{}", event.time, whose, text_of_event(event));
    console.clear_bar();
    console.note(said);
  }
}

// Gives the session more of its deformable body where the needle aims, and says so.
void keep_corridors(CorridorKeeper& keeper, HandSession& session, std::string& said, Console& console) {
  const HandMoment& now = session.moment();
  if (now.ticks == 0) return;
  CorridorKeeper::News news = keeper.look(now.needle, now.ticks - 1);
  if (news.ready) session.add_corridor(*news.ready);
  if (!news.sentence) return;
  said = *news.sentence;
  console.clear_bar();
  console.note(said);
}

// What looks after the deformable body: one of both, or none.
struct BodyKeepers {
  CorridorKeeper* corridors = nullptr;
  MovingPatient* moving = nullptr;
};

// Until the person, the device or the time ends it, or the disk refuses. `window`, `second`: may be null.
RunResult perform(HandSession& session, SecondHand* second, const PerformArguments& arguments, const Case& patient,
                  const HasForce& has_force, MouseWindow* window, const BodyKeepers& keepers, Console& console) {
  RunResult result;
  Keys keys;
  const EndOnSignal signals;
  asked_to_end.store(false);
  const Progress progress = console.progress();
  // The second one first: a vendor may take its time, in which the needle must not wait.
  if (second != nullptr) {
    try {
      second->start();
    } catch (const SystemError& error) {
      console.note(fmt::format("the second hand takes no part: {}", error.what()));
      second = nullptr;
    }
  }
  session.start();
  ServoTick& servo = session.servo().tick();
  obey('a', servo, second);
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  std::string said;  // the guard's last word
  bool was_faulted = false;
  while (!asked_to_end.load() && !session.failed() && elapsed() < arguments.longest) {
    std::this_thread::sleep_for(window == nullptr ? look_interval : quick_look_interval);
    while (const std::optional<char> key = keys.next()) obey(*key, servo, second);
    if (window != nullptr) {
      window->take();
      while (const std::optional<char> key = window->next_key()) obey(*key, servo, second);
    }
    tell_events(servo, has_force.first, "", said, console);
    if (second != nullptr) tell_events(second->servo().tick(), has_force.second, "second hand: ", said, console);
    if (keepers.corridors != nullptr) keep_corridors(*keepers.corridors, session, said, console);
    if (keepers.moving != nullptr) keepers.moving->look(session, patient, said, console);
    const ServoSnapshot& now = servo.snapshot();
    if (now.device.ended()) asked_to_end.store(true);
    const bool faulted = now.state == GuardState::faulted;
    if (second != nullptr && faulted && !was_faulted) {
      // A plunger that goes on pushing while the needle has let go belongs to no procedure.
      second->disarm();
      console.note("the second hand is disarmed too, because the needle's device is at fault; press a to arm both");
    }
    was_faulted = faulted;
    if (window != nullptr && window->ultrasound() != nullptr)
      window->ultrasound()->follow(second, keepers.moving == nullptr ? nullptr : keepers.moving->body().get());
    if (window != nullptr) window->show(scene_of(now, session.moment(), patient, elapsed(), said));
    if (progress) {
      std::string line = screen(now, session.moment(), patient.library);
      if (second != nullptr) line += "  " + text_of(second->role(), second->moment());
      progress(line, elapsed() / arguments.longest);
    }
  }
  result.operator_finished = asked_to_end.load();
  if (second != nullptr && !second->stop()) {
    result.notes.emplace_back("the second device did not let itself be stopped; switch it off and on again");
  }
  if (!session.finish()) {
    result.notes.emplace_back("the device did not let itself be stopped; switch it off and on again");
  }
  if (second != nullptr) tell_events(second->servo().tick(), has_force.second, "second hand: ", said, console);
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
void require_same_rate(const ChosenDevice& chosen, const DeviceAbilities& device, double rate) {
  if (std::abs(device.rate - rate) <= 0.01 * rate) return;
  if (chosen.is_simulated()) {
    throw InputError(
        fmt::format("the simulated hand moves at {:g} Hz and the case at {:g} Hz; add --settings rate_Hz={:g}",
                    device.rate, rate, rate));
  }
  if (chosen.is_recorded()) {
    throw InputError(
        fmt::format("{} was recorded at {:g} Hz and the case runs at {:g} Hz, expected the same rate; set "
                    "rate_Hz of the case's haptics to the recording's",
                    chosen.identity, device.rate, rate));
  }
  if (!device.owns_loop) return;
  throw InputError(fmt::format(
      "the device runs at {:g} Hz and the case at {:g} Hz; set rate_Hz of the case's haptics to the device's",
      device.rate, rate));
}

// Those of the device that is held; with a recording, of the device that was held then.
DeviceLimits limits_of(const ChosenDevice& chosen, const DeviceAbilities& device, const DeviceLimits& of_case) {
  if (!chosen.is_recorded()) return limits_of(device, of_case);
  return read_recorded_hand(chosen.identity).limits.value_or(of_case);
}

void run_perform(const PerformArguments& arguments, const CommandContext& context) {
  Console console(context);
  require_writable(arguments.output, "--output");
  if (!arguments.ultrasound.empty()) choose_pane(arguments.ultrasound);  // for its complaints
  const ChosenDevice chosen = choose_device(arguments.device);
  const std::optional<ChosenSecond> chosen_second = choose_second(arguments.second, chosen);
  Case patient = load_case(arguments.folder, console.progress());
  apply(arguments.forces, patient.description.haptics);
  if (!patient.description.procedure.path) {
    throw InputError(
        fmt::format("{}: the case has no planned path, so there is no place to put the hand; make the "
                    "case with --entry and --target",
                    arguments.folder));
  }
  const std::optional<ProbeFace> probe =
      choose_body(arguments.body, chosen_second, patient.description.haptics.resistance);
  const std::shared_ptr<const BodyDescription> body = prepare_body(
      patient, arguments.folder, {}, console.progress(), [&](const std::string& text) { console.note(text); });
  const NeedlePath path = *patient.description.procedure.path;
  std::optional<UltrasoundChoice> ultrasound;
  if (!arguments.ultrasound.empty()) ultrasound = choose_pane(arguments.ultrasound);
  const bool has_ultrasound = ultrasound.has_value();
  const std::unique_ptr<MouseWindow> window =
      chosen.is_mouse() || has_ultrasound
          ? std::make_unique<MouseWindow>(patient.description.name, has_ultrasound, chosen.is_mouse())
          : nullptr;
  std::optional<MovingPatient> moving;
  if (probe) moving.emplace(patient, *body, *probe, console);
  std::unique_ptr<BodyView> view;
  std::unique_ptr<NodeField> field;
  if (window != nullptr && moving) {
    view = std::make_unique<BodyView>(patient, *body, moving->body());
  } else if (window != nullptr && body != nullptr) {
    const ElasticBody elastic(*body, plan_body(*body, console.progress()), {}, console.progress());
    view = std::make_unique<BodyView>(patient, *body, elastic, console.progress());
    if (ultrasound) field = std::make_unique<NodeField>(elastic, *body, path, console.progress());
  }
  DevicePort port(*chosen.driver, chosen.identity, settings_along(path, chosen, arguments.device));
  DeviceAbilities device = port.abilities();
  complete_from_table(device);
  const DeviceCalibration calibration =
      arguments.no_calibration ? DeviceCalibration() : calibration_of(chosen, device);
  apply(calibration, device);
  require_same_rate(chosen, device, patient.description.haptics.rate);
  patient.description.device = limits_of(chosen, device, patient.description.device);
  DeviceLimits& limits = patient.description.device;  // of what the needle's side may ask for
  limits.stiffness /= arguments.scale * arguments.force_scale;
  limits.peak_force /= arguments.force_scale;
  limits.continuous_force /= arguments.force_scale;
  limits.peak_torque /= arguments.force_scale;
  std::optional<OpenSecond> second_device;
  if (chosen_second) {
    second_device.emplace(*chosen_second, chosen, device, path, patient.description.haptics.rate,
                          !arguments.no_calibration);
    if (!second_device->calibrated_at().empty()) {
      console.note(fmt::format("second device calibrated {}", second_device->calibrated_at()));
    }
  }
  ServoSettings settings;
  settings.rate = patient.description.haptics.rate;
  settings.workspace = workspace_about(path);
  settings.workspace.scale = arguments.scale;
  settings.workspace.force_scale = arguments.force_scale;
  if (!calibration.empty()) console.note(fmt::format("calibrated {}", calibration.measured_at));
  apply(calibration, settings);
  SessionHeader header = session_header(patient, arguments.folder, path);
  header.operator_name = "hand";
  header.operator_settings =
      nlohmann::ordered_json{{"device", device.name},
                             {"driver", chosen.driver->name},
                             {"identity", chosen.identity},
                             {"settings", arguments.device.settings},
                             {"scale", arguments.scale},
                             {"force_scale", arguments.force_scale},
                             {"calibration", calibration.empty() ? "" : calibrations_xml({&calibration, 1})}}
          .dump();
  header.device = limits;
  if (second_device) header.second = second_device->header();
  if (probe) header.moving_body = text_of(*probe, body->mesh.nodes.size());
  const auto kept = std::make_shared<const Case>(patient);
  const Case& whole = *kept;
  std::optional<CorridorKeeper> keeper;
  // A body that moves leads its own corridor to where the needle aims.
  if (body != nullptr && !moving) keeper.emplace(kept, body, path.length(), HapticTick::most_corridors - 1);
  if (ultrasound) {
    window->show_ultrasound(std::make_unique<UltrasoundPane>(whole, *ultrasound, ScanBody{body, std::move(field)},
                                                             MouseWindow::ultrasound_x, 0.0, console.progress()));
  }
  const std::unique_ptr<SecondHand> second =
      second_device ? second_device->hand(kept, moving ? moving->body() : nullptr) : nullptr;
  HandSession session(std::move(patient), header, arguments.output, arguments.overwrite, std::move(port), device,
                      settings, second_device ? second_device->link() : nullptr);
  if (moving) session.press(moving->body());
  if (ultrasound) session.show_on(window->ultrasound()->thread());
  if (view) {
    session.show_on(view->display());
    window->show_body(std::move(view));
  }
  const HasForce has_force{device.peak_force > 0.0, second_device && second_device->has_force()};
  RunResult result = perform(session, second.get(), arguments, whole, has_force, window.get(),
                             {keeper ? &*keeper : nullptr, moving ? &*moving : nullptr}, console);
  if (result.ticks == 0) throw SystemError("the device did not answer once; is it switched on?");
  const double rate = static_cast<double>(result.ticks) / result.wall_time;
  if (std::abs(rate - settings.rate) > 0.05 * settings.rate) {
    console.note(
        fmt::format("the device ran at {:.0f} Hz instead of {:g}; the tissue's time was {:.2f} times the clock's",
                    rate, settings.rate, rate / settings.rate));
  }
  if (ultrasound) console.note(window->ultrasound()->tell(result.wall_time));
  if (second_device && second_device->link()->lost.load() > 0) {
    console.note(fmt::format("{} samples of the second hand were lost, because the disk was too slow",
                             second_device->link()->lost.load()));
  }
  if (moving) moving->tell(static_cast<double>(result.ticks) / settings.rate, console);
  const Outcome outcome = read_outcome(arguments.output, whole, std::move(result));
  for (const std::string& note : outcome.run.notes) console.note(note);
  console.note(fmt::format("{} of {} ticks were late (by {:.2f} ms at worst)", outcome.run.missed_deadlines,
                           outcome.run.ticks, 1e3 * outcome.run.worst_lateness));
  print(console, outcome, whole);
  nlohmann::ordered_json json = json_of(outcome, whole);
  if (ultrasound) json["ultrasound_pictures"] = window->ultrasound()->pictures();
  console.json(json.dump(2));
}

}  // namespace

void add_perform_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<PerformArguments>();
  CLI::App* command =
      add_command(app, "perform", "Your own hand performs the procedure on a haptic device", perform_footer);
  add_text(*command, "CASE", arguments->folder, "Folder of the case").required();
  add_text(*command, "DEVICE", arguments->device.device, "DRIVER or DRIVER:IDENTITY, as 'devices list' prints it")
      .required();
  add_driver_settings(*command, arguments->device);
  add_text(*command, "-o,--output", arguments->output, "Session file");
  add_switch(*command, "--overwrite", arguments->overwrite, "Replace the session file if it exists");
  add_number(*command, "--scale", arguments->scale, 0.1, 10.0, "mm of the needle per mm of the hand, 0.1 to 10");
  add_number(*command, "--force-scale", arguments->force_scale, 0.01, 1.0,
             "N at the hand per N of the needle, for weak devices; recorded, never scored; 0.01 to 1");
  add_switch(*command, "--no-calibration", arguments->no_calibration,
             "Leave out what 'devices calibrate' found of this device");
  add_number(*command, "--max-time", arguments->longest, 1.0, 3600.0, "s after which it ends, 1 to 3600");
  add_second_options(*command, arguments->second);
  add_force_options(*command, arguments->forces);
  add_body_option(*command, arguments->body);
  add_text(*command, "--ultrasound", arguments->ultrasound,
           "\"PROBE SETTING=VALUE ...\": its picture live in a window, with the needle and the tissue that it drags; "
           "view, at, from, press_mm, depth_mm, gain_dB, dynamic_range_dB, focus_mm, frequency_MHz");
  on_run(*command, [arguments, &context] { run_perform(*arguments, context); });
}

}  // namespace bodkin
