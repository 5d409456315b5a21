#include "station/station.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "patient/prepared_body.h"
#include "session/body_displacement.h"
#include "session/left_needles.h"
#include "station/body_glide.h"
#include "station/body_supervisor.h"
#include "station/device_choice.h"
#include "station/device_record.h"
#include "station/followed_points.h"
#include "station/guard_sentence.h"
#include "station/node_field.h"
#include "station/probe_contact.h"
#include "station/real_time_check.h"
#include "station/recorded_hand.h"
#include "station/scan_log.h"
#include "station/sight_watch.h"
#include "station/station_checks.h"
#include <fmt/format.h>

#include "core/error.h"
#include "haptics/calibration.h"
#include "haptics/guard_event.h"
#include "haptics/stable_stiffness.h"
#include "imaging/ultrasound/acoustic_volume.h"

namespace bodkin::station {

namespace {

using Clock = std::chrono::steady_clock;
constexpr double rate_tolerance = 0.05;  // of the rate; a device that misses it by more is reported

}  // namespace

struct Station::Parts {
  Parts(StationOptions from, StationObserver& watching);

  void prepare_patient();
  void follow_points(const std::vector<Vec3>& points);
  haptics::DevicePort open_device();
  void open_second(const haptics::DeviceAbilities& first);
  session::SessionHeader header() const;
  void prepare_ultrasound(const Pose& probe);

  double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
  void add_message(const std::string& sentence);
  void report_events(haptics::ServoTick& servo, bool has_force, const char* whose);
  void press_plunger(bool on);
  void disarm_second_on_fault();
  void update_scan();
  void update_displacements();
  void add_summary(session::RunResult& run) const;

  StationOptions options;  // without the patient
  StationObserver& observer;
  anatomy::NeedlePath path;
  std::shared_ptr<anatomy::Case> patient;
  std::shared_ptr<const fem::BodyDescription> body;    // null: rigid
  std::shared_ptr<fem::BodyThread> moving;             // null: rigid or static
  std::shared_ptr<const fem::ContactBody> whole_body;  // of contact points; else null
  std::optional<FollowedPoints> points;                // of the observer
  std::unique_ptr<NodeField> field;                    // of the needle, until the ultrasound takes it
  haptics::DeviceAbilities device;
  haptics::DeviceCalibration calibration;
  haptics::StableStiffness stiffness;  // that the device may be told to render
  haptics::ServoSettings servo;
  std::optional<SecondDevice> second_device;
  std::shared_ptr<ScanThread> scan;  // null: no ultrasound
  ScanSetup setup;
  std::optional<ScanLog> scan_log;  // with `scan`
  std::uint64_t shown_steps = 0;    // of a moving body
  std::unique_ptr<SecondHand> second;
  std::optional<BodySupervisor> supervisor;
  std::unique_ptr<HandSession> session;
  SightWatch sight;
  bool second_runs = false, was_faulted = false;
  BodyGlide glide;
  Clock::time_point begin = Clock::now();
  std::atomic<bool> end_asked{false};
  StationStatus status;
};

Station::Parts::Parts(StationOptions from, StationObserver& watching)
    : options(std::move(from)),
      observer(watching),
      path(path_of(options)),
      patient(std::make_shared<anatomy::Case>(std::move(options.patient))) {
  session::check_left_needles(options.left_needles);
  patient->left_needles = options.left_needles;
}

void Station::Parts::prepare_patient() {
  body = patient::prepare_body(
      *patient, options.case_folder, options.path, observer.progress(),
      [this](const std::string& text) { observer.note(text); }, &whole_body);
  patient->description.procedure.path = path;
  if (!options.moving_body) return;
  if (const std::string slow = slow_motion_warning(body->mesh.nodes.size()); !slow.empty()) observer.note(slow);
  moving = std::make_shared<fem::BodyThread>(*body, moving_settings(options), breath_of(*patient));
}

// Precomputes the motion of the points requested by the observer, and of the ultrasound.
void Station::Parts::follow_points(const std::vector<Vec3>& wanted) {
  if (body == nullptr || (wanted.empty() && !options.ultrasound)) return;
  const Progress progress = observer.progress();
  const fem::ElasticBody elastic = body_of_picture(*body, whole_body.get(), patient->prepared.path, progress);
  const fem::LeftNeedleForces left(whole_body.get(), options.left_needles);
  const auto surface = moving == nullptr ? std::span<const std::uint32_t>() : moving->surface();
  if (!wanted.empty())
    points.emplace(elastic, body->mesh, patient->prepared.path, wanted, progress, left, whole_body, surface);
  if (options.ultrasound) field = std::make_unique<NodeField>(elastic, *body, path, progress, left, whole_body);
}

haptics::DevicePort Station::Parts::open_device() {
  const DeviceChoice& choice = options.device;
  haptics::DevicePort port(*choice.driver, choice.identity, settings_along(path, choice));
  device = port.abilities();
  complete_from_table(device);
  if (options.use_calibration) calibration = calibration_of(choice, device);
  haptics::apply(calibration, device);
  const double rate = patient->description.haptics.rate;
  require_same_rate(choice, device, rate);
  stiffness = haptics::stable_stiffness(device, rate, calibration.friction);
  device.stiffness = stiffness.weakest();
  servo.rate = rate;
  servo.workspace = workspace_about(path);
  servo.workspace.scale = options.scale;
  servo.workspace.force_scale = options.force_scale;
  haptics::apply(calibration, servo);
  if (options.mannequin) place_on(*options.mannequin, patient->description.needle.length, servo.workspace);
  anatomy::DeviceLimits& limits = patient->description.device;  // limit of requests from the needle's side
  limits = limits_with(choice, device, limits);
  if (!choice.is_recorded()) limits = with_stiffness(stiffness, servo.workspace, path, limits);
  limits.stiffness /= options.scale * options.force_scale;
  limits.lateral_stiffness /= options.scale * options.force_scale;
  limits.peak_force /= options.force_scale;
  limits.continuous_force /= options.force_scale;
  limits.peak_torque /= options.force_scale;
  if (stiffness.is_cut() && !choice.is_recorded()) observer.note(stiffness_sentence(stiffness));
  if (is_kept_low(choice, device, options.allow_late, "", observer)) servo.guard.user_force = late_force;
  return port;
}

void Station::Parts::open_second(const haptics::DeviceAbilities& first) {
  if (options.second) {
    const double rate = patient->description.haptics.rate;
    second_device.emplace(*options.second, options.device, first, path, rate, options.use_calibration);
    if (second_device->stiffness().is_cut() && !options.second->device.is_recorded())
      observer.note("second hand: " + stiffness_sentence(second_device->stiffness()));
    const haptics::DeviceAbilities& known = second_device->abilities();
    if (is_kept_low(options.second->device, known, options.allow_late, "second hand: ", observer))
      second_device->limit_force(late_force);
    const std::string& when = second_device->calibrated_at();
    if (!when.empty()) observer.note(fmt::format("second device calibrated {}", when));
  }
  if (!calibration.empty()) observer.note(fmt::format("calibrated {}", calibration.measured_at));
}

session::SessionHeader Station::Parts::header() const {
  session::SessionHeader header = session::session_header(*patient, options.case_folder, path);
  header.operator_name = "hand";
  header.operator_settings = device_record(options, device, stiffness, calibration);
  header.device = patient->description.device;
  if (second_device) header.second = second_device->header();
  if (options.ultrasound) header.ultrasound = options.ultrasound->probe;
  if (moving != nullptr)
    header.moving_body = session::moving_body_text(moving_settings(options), body->mesh.nodes.size());
  return header;
}

void Station::Parts::prepare_ultrasound(const Pose& probe) {
  const UltrasoundChoice& choice = *options.ultrasound;
  const auto volume = imaging::acoustic_volume(*patient, observer.progress());
  imaging::Ultrasound machine(volume, choice.probe, choice.settings, choice.detail);
  setup = {probe, choice.settings};
  const std::optional<anatomy::BreathField> breath = breath_of(*patient);
  ScanBody seen{body, std::move(field), moving != nullptr, breath, LeftNeedleMotion(options.left_needles, breath)};
  scan =
      std::make_shared<ScanThread>(volume, std::move(machine), patient->description.needle, std::move(seen), setup);
  scan_log.emplace(patient, choice.probe);
}

void Station::Parts::add_message(const std::string& sentence) {
  status.message = sentence;
  observer.note(sentence);
}

// `whose`: beginning of a sentence.
void Station::Parts::report_events(haptics::ServoTick& from, bool has_force, const char* whose) {
  haptics::GuardEvent event;
  while (from.next_event(event)) {
    // Every puncture triggers the slew rate limit, and every release the passivity limit: not worth a report.
    if (event.reason == haptics::GuardReason::slew || event.reason == haptics::GuardReason::passivity) continue;
    const bool peak = event.reason == haptics::GuardReason::peak || event.reason == haptics::GuardReason::torque_peak;
    if (peak && !has_force) continue;  // the peak of a device without force is 0
    add_message(fmt::format("{:.1f} s: {}{}", event.time, whose, sentence_of(event)));
  }
}

// No procedure has a plunger that keeps pushing after the needle was released.
void Station::Parts::disarm_second_on_fault() {
  const bool faulted = status.servo.state == haptics::GuardState::faulted;
  if (second_runs && faulted && !was_faulted) {
    second->disarm();
    observer.note("the second hand is disarmed too, because the needle's device is at fault; press a to arm both");
  }
  was_faulted = faulted;
}

void Station::Parts::press_plunger(bool on) {
  status.plunger_pressed = on && patient->description.haptics.parts.syringe.has_value();
  session->set_thumb(on ? simulation::Thumb() : simulation::Thumb::of_force(0.0));
}

void Station::Parts::update_scan() {
  if (scan == nullptr) return;
  status.probe_is_held = second_runs && second->role() == session::SecondRole::probe;
  scan->set_setup({status.probe_is_held ? probe_in_hand(second->tool()) : setup.probe, setup.settings});
  status.ultrasound = &scan->picture();
  scan_log->follow(*status.ultrasound, status.needle.ticks, *session);
}

void Station::Parts::update_displacements() {
  if (moving != nullptr) {
    const fem::BodySnapshot& now = moving->snapshot();
    const bool is_new = now.steps != std::exchange(shown_steps, now.steps);
    if (is_new && points) points->update(now.displacements, now.held_nodes());
    if (is_new && scan != nullptr) scan->set_displacements(now.displacements, now.held_nodes());
  }
  if (points) status.displacements = points->displacements();
}

void Station::Parts::add_summary(session::RunResult& run) const {
  const double rate = static_cast<double>(run.ticks) / run.wall_time;
  if (std::abs(rate - servo.rate) > rate_tolerance * servo.rate) {
    run.notes.push_back(
        fmt::format("the device ran at {:.0f} Hz instead of {:g}; the tissue's time was {:.2f} times the clock's",
                    rate, servo.rate, rate / servo.rate));
  }
  if (std::string unseen = sight.summary(run.wall_time); !unseen.empty()) run.notes.push_back(std::move(unseen));
  if (scan != nullptr) {
    const std::uint64_t pictures = scan->picture().number;
    run.notes.push_back(fmt::format("{} ultrasound pictures, {:.0f} a second", pictures,
                                    static_cast<double>(pictures) / run.wall_time));
  }
  if (second_device && second_device->link()->lost.load() > 0) {
    run.notes.push_back(fmt::format("{} samples of the second hand were lost, because the disk was too slow",
                                    second_device->link()->lost.load()));
  }
  if (!supervisor) return;
  for (std::string& sentence : supervisor->summary(static_cast<double>(run.ticks) / servo.rate))
    run.notes.push_back(std::move(sentence));
}

Station::Station(StationOptions options, StationObserver& observer) {
  check_moving_body(options);
  parts_ = std::make_unique<Parts>(std::move(options), observer);
  Parts& parts = *parts_;
  parts.prepare_patient();
  const std::optional<UltrasoundChoice>& ultrasound = parts.options.ultrasound;
  const Pose probe = ultrasound ? first_probe(*ultrasound, *parts.patient) : Pose::Identity();
  parts.follow_points(observer.prepare(*parts.patient, parts.body.get()));
  haptics::DevicePort port = parts.open_device();
  parts.open_second(parts.device);
  const session::SessionHeader header = parts.header();
  if (parts.body != nullptr)
    parts.supervisor.emplace(parts.patient, parts.body, parts.path.length(), parts.whole_body, parts.moving);
  if (ultrasound) parts.prepare_ultrasound(probe);
  std::shared_ptr<session::SecondLink> link;
  if (parts.second_device) {
    parts.second = parts.second_device->hand(parts.patient, parts.moving);
    link = parts.second_device->link();
  }
  parts.session = std::make_unique<HandSession>(parts.patient, header, parts.options.output, parts.options.overwrite,
                                                std::move(port), parts.device, parts.servo, std::move(link));
  if (moves_along_its_axis(parts.options.device, parts.device)) parts.session->guide_along_axis();
  if (parts.supervisor) parts.supervisor->attach(*parts.session);
  if (parts.scan != nullptr) parts.session->show_on(parts.scan);
  if (parts.points) parts.session->show_on(parts.points->display());
}

Station::~Station() = default;

StationResult Station::run() {
  start();
  while (!ended()) {
    std::this_thread::sleep_for(parts_->observer.interval());
    parts_->observer.update(*this, update());
  }
  return finish();
}

void Station::start() {
  Parts& parts = *parts_;
  // The second device first: a vendor's library may be slow, and the needle must not wait for it.
  if (parts.second != nullptr) {
    try {
      parts.second->start();
      parts.second_runs = true;
    } catch (const SystemError& error) {
      parts.observer.note(fmt::format("the second hand is not used: {}", error.what()));
    }
  }
  parts.press_plunger(parts.options.device.is_simulated() || parts.options.device.is_recorded());
  parts.session->start();
  parts.begin = Clock::now();
  for (const auto& note : notes_of_pictures(parts.options.device, parts.session->servo())) parts.observer.note(note);
  command(StationCommand::arm);
}

const StationStatus& Station::update() {
  Parts& parts = *parts_;
  StationStatus& status = parts.status;
  parts.report_events(parts.session->servo().tick(), parts.device.peak_force > 0.0, "");
  if (parts.second_runs)
    parts.report_events(parts.second->servo().tick(), parts.second_device->has_force(), "second hand: ");
  if (parts.supervisor) {
    for (const std::string& sentence : parts.supervisor->update()) parts.add_message(sentence);
  }
  if (const std::string refusal = parts.session->take_refusal(); !refusal.empty()) parts.add_message(refusal);
  status.time = parts.elapsed();
  status.servo = parts.session->servo().tick().snapshot();
  status.timings = parts.session->servo().tick().timings();
  status.needle = parts.session->snapshot();
  status.diagnostic_names = parts.session->diagnostic_names();
  status.samples = parts.session->take_samples();
  status.events = parts.session->take_events();
  if (const auto lost = parts.sight.follow(status, parts.session->servo()); !lost.empty()) parts.add_message(lost);
  if (parts.second_runs) status.second = SecondStatus{parts.second->role(), parts.second->snapshot()};
  if (status.servo.device.ended()) end();
  parts.disarm_second_on_fault();
  parts.glide.follow(status.needle, status.time, parts.session->servo().tick());
  parts.update_displacements();
  parts.update_scan();
  return status;
}

void Station::follow(const std::vector<Vec3>& points, const Vec3& entry) {
  if (!parts_->points) return;
  parts_->points->follow(points, entry);
  parts_->shown_steps = 0;  // a moving body also publishes the place of these points
}

bool Station::ended() const noexcept {
  return parts_->end_asked.load() || parts_->session->failed() || parts_->elapsed() >= parts_->options.longest;
}

StationResult Station::finish() {
  Parts& parts = *parts_;
  StationResult result;
  session::RunResult& run = result.run;
  run.operator_finished = parts.end_asked.load();
  if (parts.second_runs && !parts.second->stop())
    run.notes.emplace_back("the second device could not be stopped; switch it off and on again");
  if (!parts.session->finish()) run.notes.emplace_back("the device could not be stopped; switch it off and on again");
  if (parts.second_runs)
    parts.report_events(parts.second->servo().tick(), parts.second_device->has_force(), "second hand: ");
  run.wall_time = parts.elapsed();
  run.ticks = parts.session->snapshot().ticks;
  const haptics::ServoTimings& timings = parts.session->servo().tick().timings();
  run.missed_deadlines = timings.overruns;
  run.worst_lateness = timings.lateness.maximum();
  run.records_lost = parts.session->records_lost();
  if (!holds_a_hand(parts.options.device, parts.device)) {  // otherwise it has already been reported
    for (const std::string& sentence : parts.session->servo().refused()) run.notes.push_back(sentence);
  }
  if (run.ticks == 0) throw SystemError("the device did not answer once; is it switched on?");
  parts.add_summary(run);
  if (parts.scan != nullptr) result.ultrasound_pictures = parts.scan->picture().number;
  return result;
}

void Station::command(StationCommand command) {
  using Kind = haptics::ServoCommand::Kind;
  Parts& parts = *parts_;
  haptics::ServoTick& servo = parts.session->servo().tick();
  const auto send = [&servo](Kind kind) { servo.command({.kind = kind}); };
  switch (command) {
    case StationCommand::arm:
      send(Kind::arm);
      if (parts.second_runs) parts.second->arm();
      return;
    case StationCommand::disarm:
      send(Kind::disarm);
      if (parts.second_runs) parts.second->disarm();
      return;
    case StationCommand::toggle_hold:
      return send(servo.snapshot().frozen ? Kind::unfreeze : Kind::freeze);
    case StationCommand::toggle_clutch:
      return send(servo.snapshot().clutched ? Kind::unclutch : Kind::clutch);
    case StationCommand::press_plunger:
    case StationCommand::release_plunger:
      return parts.press_plunger(command == StationCommand::press_plunger);
    case StationCommand::turn_finger:
      return parts.session->turn(&simulation::OtherHand::finger);
    case StationCommand::turn_stylet:
      return parts.session->turn(&simulation::OtherHand::stylet_moved);
    case StationCommand::turn_manometer:
      return parts.session->turn(&simulation::OtherHand::manometer_moved);
    case StationCommand::turn_breath:
      return parts.session->turn(&simulation::OtherHand::breath_held);
    case StationCommand::end:
      return end();
  }
}

bool Station::move_body(const Vec3& middle, const Mat3& rotation) {
  Parts& parts = *parts_;
  if (parts.options.mannequin || parts.second != nullptr || BodyGlide::touches(parts.session->snapshot()))
    return false;
  parts.glide.request(middle, rotation, parts.elapsed(), parts.session->servo().tick(), parts.servo.workspace);
  return true;
}

void Station::change_numbers(const anatomy::HapticSettings& haptics,
                             const std::vector<anatomy::TissueProperties>& tissues) {
  try {
    parts_->session->change_numbers(haptics, tissues);
  } catch (const InputError& refused) {
    parts_->add_message(refused.what());
  }
}

void Station::end() noexcept {
  parts_->end_asked.store(true);
}

void Station::set_scan_setup(const ScanSetup& setup) {
  parts_->setup = setup;
}

const anatomy::Case& Station::patient() const noexcept {
  return *parts_->patient;
}

}  // namespace bodkin::station
