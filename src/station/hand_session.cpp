#include "station/hand_session.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

#include "session/recorder.h"
#include "station/adjustable_tick.h"
#include "station/axial_needle.h"
#include "station/released_needle.h"
#include "station/station_checks.h"

#include "core/latest_value.h"
#include "core/single_producer_ring.h"
#include "haptics/bodkin_driver.h"
#include "simulation/haptic_tick.h"

namespace bodkin::station {

namespace {
constexpr double room_above = 30.0;  // mm between the middle of the workspace and the skin
constexpr std::size_t observed_ticks = 8000, observed_events = 512;  // two seconds at the highest rate
}  // namespace

anatomy::DeviceLimits limits_of(const haptics::DeviceAbilities& device, anatomy::DeviceLimits limits) {
  if (!device.name.empty()) limits.profile = device.name;
  if (device.peak_force > 0.0) {
    limits.peak_force = device.peak_force;
    limits.continuous_force = haptics::guard_settings(device, 1000.0).continuous_force;
    limits.peak_torque = device.peak_torque;
  }
  if (device.stiffness > 0.0) limits.stiffness = device.stiffness;
  limits.position_resolution = device.resolution;
  return limits;
}

haptics::WorkspaceSettings workspace_about(const anatomy::NeedlePath& path) {
  haptics::WorkspaceSettings workspace;
  workspace.rotation << -Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY();  // right, away, up: right, head, back
  workspace.centre = path.entry + room_above * Vec3::UnitY();
  return workspace;
}

struct HandSession::Shared {
  Shared(std::shared_ptr<const anatomy::Case> from, const session::SessionHeader& header,
         const std::filesystem::path& output, bool overwrite, std::shared_ptr<session::SecondLink> link)
      : patient(std::move(from)),
        tick(*patient),
        body(tick.body()),
        second(std::move(link)),
        plunger(header.second && header.second->role == session::SecondRole::plunger ? second.get() : nullptr),
        has_syringe(patient->description.haptics.parts.syringe.has_value()),
        recorder(
            session::SessionWriter(output, header, overwrite),
            [this](const simulation::TickRecord& record) { adjustable.keep(record); },
            session::Recorder::usual_capacity, second) {}

  haptics::Control step(const haptics::ControlInput& input) noexcept {
    simulation::TickRecord record;
    record.tick = ticks;
    record.input.needle = axial ? axial->step(input.needle, tick_in_tissue, input.dt) : input.needle;
    if (has_syringe) record.input.thumb = thumb_now();
    record.input.other =
        simulation::OtherHand::from_byte(other.load(std::memory_order_relaxed)).value_or(simulation::OtherHand());
    record.output = adjustable.step(ticks, record.input);
    tick_in_tissue = record.output.depth > 0.0;
    const Vec3 coupling_offset = body == nullptr ? Vec3(Vec3::Zero()) : body->coupling_offset();
    publish_forces(record.input.needle, coupling_offset, record.output.drawn_in);
    const ReleasedNeedle::Step carried =
        released.step(input.needle_held && tick_in_tissue, input.needle, tissue_motion(record));
    if (moving) keep_moving(record);
    note_sight((input.buttons & BODKIN_BUTTON_UNSEEN) != 0, record.output);
    if (!closed.load(std::memory_order_acquire)) recorder.push(record);
    // After the tick itself, so that a recorded sample of the second hand has its tick before it.
    if (second) second->needle.write({static_cast<double>(ticks) * tick.dt(), record.output.tissue});
    ++ticks;
    const Wrench& asked = record.output.requested;
    samples.push({static_cast<double>(record.tick) * tick.dt(), record.output.depth, asked.force.norm(),
                  record.output.resistance, record.output.constraint, record.output.tissue});
    for (const forces::Event& event : record.output.events) {
      events.push({record.tick, event});
      if (event.kind == forces::EventKind::contact || event.kind == forces::EventKind::withdrawn) past_points = false;
      if (event.kind == forces::EventKind::points_passed) past_points = true;
    }
    HandSnapshot now{ticks,
                     record.input.needle,
                     coupling_offset,
                     record.output,
                     past_points,
                     record.input.other,
                     adjustable.applied_changes(),
                     unseen_for.has_value()};
    now.output.events.clear();
    snapshot.write(now);
    return {record.output.applied, 0.0, carried.by, carried.turn};
  }

  // Displacement of the tissue at the needle from rest, by breath and by pressure on the body.
  Pose tissue_motion(const simulation::TickRecord& record) const noexcept {
    Pose motion = body == nullptr ? Pose::Identity() : body->tissue_motion();
    if (!breath) return motion;
    const Vec3 tip = record.input.needle.translation();
    motion.translation() += tip - breath->material(tip, record.output.drawn_in);
    return motion;
  }

  simulation::Thumb thumb_now() const noexcept {
    if (plunger == nullptr) return simulation::Thumb::from_byte(thumb.load(std::memory_order_relaxed));
    return simulation::Thumb::of_force(plunger->thumb_force.load(std::memory_order_relaxed));
  }

  // For displays of the body and the needle in it.
  void publish_forces(Pose needle, const Vec3& coupling_offset, double drawn_in) noexcept {
    if (!display && !scan) return;
    const fem::NodeForces forces = body == nullptr ? fem::NodeForces{} : body->node_forces();
    needle.translation() -= coupling_offset;
    if (display) display->set_forces(forces);
    if (scan) scan->set_needle(forces, needle, drawn_in);
  }

  void keep_moving(simulation::TickRecord& record) noexcept {
    simulation::TickOutput& output = record.output;
    moving->set_time(static_cast<double>(ticks) * tick.dt(), output.drawn_in);
    if (body != nullptr) moving->push_probe(body->on_held());
    const std::uint64_t step = body == nullptr ? 0 : body->applied_motion_step();
    if (step != applied_body_step.step) {
      applied_body_step = {applied_body_step.step == 0 ? 0 : applied_body_step.number + 1, record.tick, step};
      body_log->applied_steps.push(applied_body_step);
    }
    if (!moving->failed() || std::exchange(moving_failed, true)) return;
    output.events.push({forces::EventKind::moving_body_failed, output.tissue, output.depth, 0.0});
  }

  // After the tick's own events, because the tick does not know of it.
  void note_sight(bool unseen, simulation::TickOutput& output) noexcept {
    if (unseen) {
      if (!unseen_for) output.events.push({forces::EventKind::hand_lost, output.tissue, output.depth, 0.0});
      unseen_for = unseen_for.value_or(0.0) + tick.dt();
    } else if (unseen_for) {
      output.events.push({forces::EventKind::hand_seen, output.tissue, output.depth, *unseen_for});
      unseen_for.reset();
    }
  }

  std::shared_ptr<const anatomy::Case> patient;
  simulation::HapticTick tick;
  AdjustableTick adjustable{patient, tick};
  simulation::BodyPort* body;                   // of the tick; may be null
  std::shared_ptr<session::SecondLink> second;  // may be null
  const session::SecondLink* plunger;           // the same, if the second hand holds the plunger
  bool has_syringe;
  std::atomic<std::uint8_t> thumb{0}, other{0};
  std::shared_ptr<simulation::DisplayThread> display;  // may be null
  std::shared_ptr<ScanThread> scan;                    // may be null
  std::shared_ptr<fem::BodyThread> moving;             // may be null
  std::shared_ptr<session::BodyLog> body_log;          // with `moving`
  session::AppliedBodyStep applied_body_step;          // the newest; of step 0: none
  bool moving_failed = false;
  std::optional<anatomy::BreathField> breath = breath_of(*patient);
  ReleasedNeedle released;
  std::optional<AxialNeedle> axial;  // empty: the device renders force
  bool tick_in_tissue = false;       // after the tick before
  std::optional<double> unseen_for;  // s since a tracked hand was last seen; empty: it is seen
  session::Recorder recorder;
  std::uint64_t ticks = 0;
  bool past_points = false;
  LatestValue<HandSnapshot> snapshot;
  SingleProducerRing<HandSample> samples{observed_ticks};
  SingleProducerRing<session::SessionEvent> events{observed_events};
  std::atomic<bool> closed{false};  // the recording has ended, though the loop may not have
};

HandSession::HandSession(std::shared_ptr<const anatomy::Case> patient, const session::SessionHeader& header,
                         const std::filesystem::path& output, bool overwrite, haptics::DevicePort port,
                         const haptics::DeviceAbilities& device, const haptics::ServoSettings& settings,
                         std::shared_ptr<session::SecondLink> second)
    : shared_(std::make_shared<Shared>(std::move(patient), header, output, overwrite, std::move(second))),
      servo_(std::make_unique<haptics::DeviceServo>(
          std::move(port), device, settings,
          [shared = shared_](const haptics::ControlInput& input) { return shared->step(input); })) {}

HandSession::~HandSession() {
  servo_.reset();
  shared_->adjustable.stop();  // destroyed before the recorder, which it tells the acting numbers
}

void HandSession::show_on(std::shared_ptr<simulation::DisplayThread> display) {
  shared_->display = std::move(display);
}

void HandSession::show_on(std::shared_ptr<ScanThread> scan) {
  shared_->scan = std::move(scan);
}

void HandSession::guide_along_axis() {
  shared_->axial.emplace();
}

void HandSession::move_with(std::shared_ptr<fem::BodyThread> body) {
  if (shared_->body != nullptr) shared_->body->move_with(body->motion());
  shared_->body_log = std::make_shared<session::BodyLog>();
  shared_->body_log->steps = body->steps();
  shared_->recorder.follow(shared_->body_log);
  shared_->moving = std::move(body);
}

void HandSession::start() {
  servo_->start();
}

const HandSnapshot& HandSession::snapshot() noexcept {
  return shared_->snapshot.read();
}

std::span<const HandSample> HandSession::take_samples() {
  samples_.clear();
  HandSample sample;
  while (shared_->samples.pop(sample)) samples_.push_back(sample);
  return samples_;
}

std::span<const session::SessionEvent> HandSession::take_events() {
  events_.clear();
  session::SessionEvent event;
  while (shared_->events.pop(event)) events_.push_back(event);
  return events_;
}

std::span<const forces::DiagnosticName> HandSession::diagnostic_names() const noexcept {
  return shared_->tick.diagnostic_names();
}

simulation::BodyPort* HandSession::body() noexcept {
  return shared_->body;
}

bool HandSession::failed() const noexcept {
  return shared_->recorder.failed();
}

void HandSession::set_thumb(simulation::Thumb thumb) noexcept {
  shared_->thumb.store(thumb.byte(), std::memory_order_relaxed);
}

void HandSession::turn(bool simulation::OtherHand::*what) noexcept {
  std::atomic<std::uint8_t>& kept = shared_->other;
  simulation::OtherHand other =
      simulation::OtherHand::from_byte(kept.load(std::memory_order_relaxed)).value_or(simulation::OtherHand());
  other.*what = !(other.*what);
  kept.store(other.byte(), std::memory_order_relaxed);
}

void HandSession::change_numbers(const anatomy::HapticSettings& haptics,
                                 const std::vector<anatomy::TissueProperties>& tissues) {
  shared_->adjustable.request_change(haptics, tissues, [recorder = &shared_->recorder](session::NumberChange change) {
    recorder->note(std::move(change));
  });
}

void HandSession::note(const session::ScanSample& sample) {
  shared_->recorder.note(sample);
}

void HandSession::note(session::ScannedPart part) {
  shared_->recorder.note(std::move(part));
}

std::string HandSession::take_refusal() {
  return shared_->adjustable.take_refusal();
}

bool HandSession::finish() {
  const bool answered = servo_->stop();
  shared_->adjustable.stop();
  shared_->closed.store(true, std::memory_order_release);
  shared_->recorder.finish(session::timings_of(servo_->tick().timings()));
  return answered;
}

std::uint64_t HandSession::records_lost() const noexcept {
  return shared_->recorder.lost();
}

}  // namespace bodkin::station
