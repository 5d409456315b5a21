#include "haptics/servo_tick.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/settings_check.h"

namespace bodkin::haptics {

namespace {

constexpr double bounce_time = 0.020;  // s
constexpr int recent_ticks = 100;

// The period in s. Throws InputError for a rate outside the servo's range.
double checked_period(double rate) {
  check_range("servo", "rate", rate, {200.0, 4000.0}, "Hz");
  return 1.0 / rate;
}

GuardSettings with_period(GuardSettings settings, double period) {
  settings.dt = period;
  return settings;
}

bool is_down(std::uint32_t buttons, int number) noexcept {
  return number >= 0 && number < 32 && ((buttons >> number) & 1U) != 0;
}

}  // namespace

bool ServoTick::Button::step(std::uint32_t buttons, double dt) noexcept {
  if (number < 0) return false;
  changed_for = is_down(buttons, number) != down ? changed_for + dt : 0.0;
  if (changed_for < bounce_time) return false;
  down = !down;
  changed_for = 0.0;
  return true;
}

ServoTick::ServoTick(const ServoSettings& settings, Controller controller, TickClock clock)
    : period_(checked_period(settings.rate)),
      grasp_time_(settings.grasp_time),
      weight_(settings.weight * Vec3::UnitZ()),
      dead_man_button_(settings.dead_man_button),
      controller_(std::move(controller)),
      clock_(clock),
      map_(settings.workspace),
      guard_(with_period(settings.guard, period_)),
      clutch_button_{.number = settings.clutch_button},
      freeze_button_{.number = settings.freeze_button} {
  if (!controller_) throw InputError("servo: the controller is empty, expected a function that returns the force");
  check_range("servo", "weight of the handle", settings.weight, {0.0, 5.0}, "N");
  check_range("servo", "grasp time", grasp_time_, {0.0, unbounded, false, false}, "s");
}

void ServoTick::apply_commands() noexcept {
  ServoCommand command;
  while (commands_.pop(command)) {
    switch (command.kind) {
      case ServoCommand::Kind::arm:
        controller_failed_ = false;
        guard_.arm();
        break;
      case ServoCommand::Kind::disarm:
        guard_.disarm();
        break;
      case ServoCommand::Kind::freeze:
        map_.freeze(true);
        break;
      case ServoCommand::Kind::unfreeze:
        map_.freeze(false);
        break;
      case ServoCommand::Kind::clutch:
        map_.clutch(true);
        break;
      case ServoCommand::Kind::unclutch:
        map_.clutch(false);
        break;
      case ServoCommand::Kind::move_body:
        map_.move_body(command.middle, command.rotation);
        break;
    }
  }
  // After the queue, so that no queued arm command outlives a disarm.
  if (disarm_.load(std::memory_order_relaxed) && disarm_.exchange(false, std::memory_order_acquire)) guard_.disarm();
}

void ServoTick::follow_buttons(const DeviceState& device, double dt) noexcept {
  if (clutch_button_.step(device.buttons, dt)) map_.clutch(clutch_button_.down);
  if (freeze_button_.step(device.buttons, dt) && freeze_button_.down) map_.freeze(!map_.is_frozen());
}

Control ServoTick::control(const ControlInput& input) noexcept {
  if (controller_failed_) return {};
  try {
    return controller_(input);
  } catch (...) {
    controller_failed_ = true;
    return {};
  }
}

void ServoTick::record_sample(const ServoSample& sample) noexcept {
  samples_[tick_ % samples_.size()] = sample;
  for (const GuardEvent& event : guard_.events()) {
    events_.push(event);
    if (event.state != GuardState::faulted || event.reason != guard_.fault()) continue;
    report_.fault = event;
    report_.count = static_cast<std::size_t>(std::min<std::uint64_t>(tick_ + 1, FaultReport::most));
    for (std::size_t i = 0; i < report_.count; ++i) {
      report_.ticks[i] = samples_[(tick_ + 1 - report_.count + i) % samples_.size()];
    }
    reports_.write(report_);
  }
}

void ServoTick::publish_snapshot(const DeviceState& device, const Control& control) noexcept {
  ServoSnapshot snapshot;
  snapshot.tick = tick_;
  snapshot.time = time_;
  snapshot.device = device;
  snapshot.needle = map_.needle();
  snapshot.wanted = control.wrench;
  snapshot.applied = guard_.applied();
  snapshot.state = guard_.state();
  snapshot.fault = guard_.fault();
  snapshot.limits = guard_.limits();
  snapshot.energy = guard_.energy();
  snapshot.frozen = map_.is_frozen();
  snapshot.clutched = map_.is_clutched();
  snapshots_.write(snapshot);
}

void ServoTick::record_timing(double lateness, double compute) noexcept {
  const bool overrun = lateness > period_ || compute > period_;
  timings_.lateness.record(lateness);
  timings_.compute.record(compute);
  ++timings_.ticks;
  timings_.overruns += overrun ? 1 : 0;
  recent_good_ += overrun ? 0 : 1;
  if (++recent_ < recent_ticks) return;
  timings_.recent_success = static_cast<double>(recent_good_) / recent_ticks;
  recent_ = recent_good_ = 0;
  published_timings_.write(timings_);
}

Wrench ServoTick::step(const DeviceState& reported, double dt, double lateness) noexcept {
  const std::int64_t began = clock_();
  if (!(dt > 0.0)) dt = period_;
  if (std::isnan(lateness)) lateness = std::max(0.0, dt - period_);
  dt = std::min(dt, longest_dt);

  apply_commands();
  DeviceState device = reported;
  if (dead_man_button_ >= 0) device.held = device.held && is_down(device.buttons, dead_man_button_);
  const bool valid = device.fault == DeviceFault::none && is_possible(device.hand);
  if (valid) {
    hand_ = device.hand;
    seen_ = true;
    follow_buttons(device, dt);
  }

  // A faulty device leaves the needle where it was.
  const Pose needle = seen_ ? map_.step(hand_, dt) : map_.needle();
  const Control answer = seen_ ? control({.needle = needle,
                                          .dt = dt,
                                          .tick = tick_,
                                          .buttons = device.buttons,
                                          .needle_held = map_.is_held(),
                                          .guard = guard_.state()})
                               : Control{};
  map_.carry(answer.carried, answer.turned);
  grasp_ = map_.is_held() ? 0.0 : std::min(1.0, grasp_ + dt / grasp_time_);
  Wrench wanted = map_.felt(answer.wrench);
  if (grasp_ < 1.0) wanted = {grasp_ * wanted.force, grasp_ * wanted.torque};
  const Wrench& applied = guard_.step(
      device,
      {.wanted = wanted, .age = answer.age, .dt = dt, .controller_failed = controller_failed_, .weight = weight_});

  time_ += dt;
  record_sample({.tick = tick_,
                 .dt = dt,
                 .lateness = lateness,
                 .compute = static_cast<double>(clock_() - began) * 1e-9,
                 .position = device.hand.translation(),
                 .wanted = wanted.force,
                 .applied = applied.force,
                 .temperature = device.temperature,
                 .buttons = device.buttons,
                 .state = guard_.state(),
                 .fault = device.fault,
                 .held = device.held});
  publish_snapshot(device, answer);
  ++tick_;
  record_timing(lateness, static_cast<double>(clock_() - began) * 1e-9);
  return applied;
}

}  // namespace bodkin::haptics
