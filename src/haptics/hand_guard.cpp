#include "haptics/hand_guard.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/force_change.h"
#include "haptics/tick_clock.h"

namespace bodkin::haptics {

namespace {

constexpr double peak_share = 0.9;  // of the nominal peaks

constexpr double furthest = 5000.0;    // mm from the middle of the workspace
constexpr double longest_gap = 0.050;  // s between two ticks
constexpr double hold_after = 0.005;   // s of age
constexpr double decay_after = 0.015;  // s of age
constexpr double decay_time = 0.030;   // s
constexpr double fault_after = 0.050;  // s of age
constexpr double rest_speed = 20.0;    // mm/s
constexpr double rest_time = 0.050;    // s
constexpr int fast_ticks = 3;
constexpr double driven_swing = 3.0;       // times the smallest swing of a fast shake
constexpr double workspace_margin = 10.0;  // mm
constexpr double frozen_force = 0.5;       // N
constexpr double unpushed_time = 0.1;      // s without force after which a hand shakes by itself
constexpr double least_push = 0.1;         // N
constexpr double steady_force = 0.05;      // N by which a force may change that does not shake a hand
constexpr double force_window = 0.35;      // s over which that is measured: at least one cycle
constexpr double lever = 30.0;             // mm, lever on which the tool's rotation is watched
constexpr double turning_noise = 0.3;      // mm on that lever
constexpr double useful_phase = 1.0;       // rad by which damping may lag and still damp
constexpr double warm = 0.75, hot = 0.9;   // of the temperature: continuous force from `hot` on, zero at 1
constexpr double quiet_time = 0.1;         // s without a limit before its next intervention is a new event
constexpr double never = -1e9;             // s

bool finite(const Wrench& wrench) noexcept {
  return std::isfinite(wrench.force.squaredNorm()) && std::isfinite(wrench.torque.squaredNorm());
}

Wrench scaled(const Wrench& wrench, double share) noexcept {
  return {wrench.force * share, wrench.torque * share};
}

// A wall of stiffness K whose force is d periods late leaks 1 + 2 d times as much (stable_stiffness.h).
double delayed_stiffness(const GuardSettings& settings) noexcept {
  const double late = settings.delay / settings.dt + (settings.sent_with_next_tick ? 1.0 : 0.0);
  return settings.stiffness * (1.0 + 2.0 * late);
}

}  // namespace

bool is_possible(const Pose& hand) noexcept {
  const Mat3 turn = hand.linear();
  const bool rotation =
      (turn.transpose() * turn - Mat3::Identity()).cwiseAbs().maxCoeff() < 1e-3 && turn.determinant() > 0.0;
  return hand.matrix().allFinite() && rotation && hand.translation().norm() < furthest;
}

HandGuard::HandGuard(const GuardSettings& settings)
    : settings_((bodkin::check(settings, "device"), settings)),
      motion_(settings.dt),
      fast_(fast_oscillation(settings.oscillation_amplitude)),
      driven_(driven_oscillation(driven_swing * settings.oscillation_amplitude, delayed_stiffness(settings),
                                 settings.dt)),
      slow_(
          slow_oscillation(driven_swing * settings.oscillation_amplitude, delayed_stiffness(settings), settings.dt)),
      round_trips_(0.5 * driven_swing * settings.oscillation_amplitude,
                   slow_oscillation(0.0, delayed_stiffness(settings), settings.dt).gain),
      swings_(settings.oscillation_amplitude),
      turns_(turning_noise),
      passivity_(settings.damping),
      sent_force_(settings.delay, settings.sent_with_next_tick),
      sent_damping_(settings.delay, settings.sent_with_next_tick) {
  limited_.fill(never);
}

double HandGuard::bound() const noexcept {
  return std::min(settings_.user_force, peak_share * settings_.peak_force);
}

void HandGuard::report(GuardReason reason, double value, double limit, GuardReason cause,
                       DeviceFault fault) noexcept {
  events_.push({tick_, time_, reason, cause, fault, state_, value, limit});
}

// A limit acts in spells; the beginning of each is an event.
void HandGuard::limit_by(GuardReason reason, double value, double limit) noexcept {
  const auto index = static_cast<std::size_t>(reason);
  limits_ |= 1U << index;
  if (time_ - limited_[index] > quiet_time) report(reason, value, limit);
  limited_[index] = time_;
}

void HandGuard::end_force(bool at_once) noexcept {
  fading_ = applied_;
  faded_ = at_once ? 1.0 : 0.0;
  ramp_ = 0.0;
  reduction_.reset();
  arming_for_ = -1.0;
}

void HandGuard::fail(GuardReason reason, double value, double limit, DeviceFault fault) noexcept {
  const bool sound = reason == GuardReason::not_finite || reason == GuardReason::stale_fault ||
                     reason == GuardReason::controller_failed || reason == GuardReason::frozen ||
                     reason == GuardReason::oscillation;
  // A device that fails during the fading of a force ends it at once.
  if (is_armed() || !sound) end_force(!sound);
  state_ = GuardState::faulted;
  fault_ = reason;
  report(reason, value, limit, GuardReason::none, fault);
}

void HandGuard::release(GuardReason reason) noexcept {
  end_force(false);
  state_ = GuardState::disarmed;
  fault_ = GuardReason::none;
  report(reason);
}

void HandGuard::ramp_from_zero() noexcept {
  state_ = GuardState::ramping;
  fault_ = GuardReason::none;
  ramp_ = 0.0;
  faded_ = 1.0;
  fast_ticks_ = 0;
  still_for_ = window_for_ = force_range_.last = torque_range_.last = 0.0;
  applied_ = Wrench{};
  passivity_.reset();
  fast_.reset();
  driven_.reset();
  slow_.reset();
  round_trips_.reset();
  swings_.reset();
  turns_.reset();
  reduction_.reset();
}

// A late simulation is bridged for a while.
void HandGuard::watch_age(double age) noexcept {
  if (!(age <= fault_after)) {
    fail(GuardReason::stale_fault, age, fault_after);
  } else if (age > hold_after && state_ != GuardState::holding) {
    state_ = GuardState::holding;
    held_ = applied_;
    report(GuardReason::stale, age, hold_after);
  } else if (age <= hold_after && state_ == GuardState::holding) {
    state_ = ramp_ < 1.0 ? GuardState::ramping : GuardState::active;
    report(GuardReason::fresh_again, age, hold_after);
  }
}

// Evaluates the hand's motion. Called while armed.
void HandGuard::watch_hand(double dt) noexcept {
  fast_ticks_ = motion_.speed() > settings_.speed_limit ? fast_ticks_ + 1 : 0;
  if (motion_.jumped()) return fail(GuardReason::jump, motion_.moved().norm(), 0.0);
  if (fast_ticks_ >= fast_ticks) return fail(GuardReason::too_fast, motion_.speed(), settings_.speed_limit);
  if (motion_.mean_speed() > settings_.speed_limit) {
    return fail(GuardReason::too_fast, motion_.mean_speed(), settings_.speed_limit);
  }
  // It begins under force, and only motion ends it: a relaxing tissue, or a pause of the ticks followed by a new
  // ramp, must not give frozen readings another half second.
  const bool begins = applied_.force.norm() > frozen_force;
  still_for_ = motion_.is_still() && (begins || still_for_ > 0.0) ? still_for_ + dt : 0.0;
  if (settings_.frozen_time > 0.0 && still_for_ > settings_.frozen_time) {
    return fail(GuardReason::frozen, still_for_, settings_.frozen_time);
  }
  watch_oscillation(dt);
}

void HandGuard::calm(ForceReduction::Step step) noexcept {
  switch (step) {
    case ForceReduction::Step::none:
      return;
    case ForceReduction::Step::softer:
      return limit_by(GuardReason::halved, reduction_.oscillation().frequency, 0.0);
    case ForceReduction::Step::damped:
      return limit_by(GuardReason::damping, reduction_.oscillation().frequency, 0.0);
    case ForceReduction::Step::none_left:
      return fail(GuardReason::oscillation, reduction_.oscillation().frequency);
  }
}

void HandGuard::watch_range(double dt) noexcept {
  const auto follow = [this](Range& range, const Vec3& now) {
    if (window_for_ == 0.0) range.low = range.high = now;
    range.low = range.low.cwiseMin(now);
    range.high = range.high.cwiseMax(now);
  };
  follow(force_range_, held_force_);
  follow(torque_range_, applied_.torque);
  window_for_ += dt;
  if (window_for_ < force_window) return;
  for (Range* range : {&force_range_, &torque_range_}) range->last = (range->high - range->low).maxCoeff();
  window_for_ = 0.0;
}

// The oscillation found by any watch; none: a frequency of 0.
Oscillation HandGuard::find_oscillation(double dt) noexcept {
  const auto of = [](const auto& watch, bool turns) { return Oscillation{watch.frequency(), watch.width(), turns}; };
  const bool fast = fast_.step(motion_.moved(), held_force_, dt);
  // Judged by the tissue's force before damping: damping that works in every cycle hides an oscillating hand without
  // ending the oscillation.
  const Vec3 of_tissue = held_force_ - held_damping_;
  const bool driven = driven_.step(motion_.moved(), of_tissue, dt);
  const bool slow = slow_.step(motion_.moved(), of_tissue, dt);
  const bool uneven = round_trips_.step(motion_.moved(), of_tissue, dt);

  watch_range(dt);
  const bool fast_or_wide = swings_.step(motion_.moved(), dt);
  const bool turns_fast_or_wide = turns_.step(lever * motion_.turned(), dt);
  const bool pushed = held_force_.norm() > least_push || applied_.torque.norm() > lever * least_push;
  unpushed_for_ = pushed ? 0.0 : unpushed_for_ + dt;
  if (unpushed_for_ > unpushed_time) {
    swings_.reset();
    turns_.reset();
  }
  if (fast) return of(fast_, false);
  if (driven) return of(driven_, false);
  if (slow) return of(slow_, false);
  if (uneven) return of(round_trips_, false);
  if (unpushed_for_ > unpushed_time) return {};
  // A small swing that continues under a constant force is the hand's own.
  if (fast_or_wide || (swings_.lasts() && force_range_.last > steady_force)) return of(swings_, false);
  if (turns_fast_or_wide || (turns_.lasts() && torque_range_.last > lever * steady_force)) return of(turns_, true);
  return {};
}

// Detects whether the force makes the hand oscillate. Called while armed.
void HandGuard::watch_oscillation(double dt) noexcept {
  calm(reduction_.step(motion_.moved(), lever * motion_.turned(), dt));
  if (!is_armed()) return;
  const Oscillation seen = find_oscillation(dt);
  if (seen.frequency == 0.0 || reduction_.is_watching()) return;
  calm(reduction_.begin(seen));
  swings_.reset();
  turns_.reset();
}

// N s/mm of damping for a hand that keeps shaking: none if it would be so late that it drives the hand.
double HandGuard::calming_damping() const noexcept {
  if (!reduction_.damps()) return 0.0;
  const double period = settings_.dt * (settings_.sent_with_next_tick ? 1.0 : 0.0);
  const double late = settings_.delay + period + 2.0 * settings_.dt;  // half a hold, half of 3 ms of velocity
  return 2.0 * std::numbers::pi * reduction_.oscillation().frequency * late < useful_phase ? settings_.damping : 0.0;
}

// Everything that ends the force.
void HandGuard::watch(const DeviceState& device, const GuardInput& input, double dt) noexcept {
  const bool possible = is_possible(device.hand);
  if (possible) {
    motion_.step(device.hand, device.velocity, dt);
  } else {
    motion_.reset();
  }
  resting_for_ = possible && motion_.mean_speed() < rest_speed ? resting_for_ + dt : 0.0;

  const DeviceFault fault = device.fault == DeviceFault::none && !possible ? DeviceFault::bad_data : device.fault;
  const DeviceFault before = device_fault_;
  device_fault_ = fault;
  if (device.fault != DeviceFault::none) {
    if (fault != before) fail(GuardReason::device_fault, 0.0, 0.0, device.fault);
    return;
  }
  if (fault != DeviceFault::none) {
    if (fault != before) fail(GuardReason::bad_pose, 0.0, 0.0, fault);
    return;
  }
  if (!is_armed()) return;
  if (disarming_) return release(GuardReason::disarmed);
  if (!device.held) return release(GuardReason::released);
  if (dt > longest_gap) {
    report(GuardReason::tick_gap, dt, longest_gap);
    const double still_for = still_for_;
    ramp_from_zero();
    still_for_ = still_for;
  }
  if (input.controller_failed) return fail(GuardReason::controller_failed);
  if (!finite(input.wanted)) return fail(GuardReason::not_finite);
  watch_hand(dt);
  if (is_armed()) watch_age(input.age);
}

GuardReason HandGuard::obstacle(const DeviceState& device, const GuardInput& input) const noexcept {
  if (device.fault != DeviceFault::none) return GuardReason::device_fault;
  if (!is_possible(device.hand)) return GuardReason::bad_pose;
  if (!device.held) return GuardReason::released;
  if (input.controller_failed) return GuardReason::controller_failed;
  if (!finite(input.wanted)) return GuardReason::not_finite;
  if (!(input.age <= hold_after)) return GuardReason::stale;
  if (input.wanted.force.norm() > settings_.arming_force) return GuardReason::pulling;
  if (resting_for_ < rest_time) return GuardReason::moving;
  return GuardReason::none;
}

void HandGuard::try_to_arm(const DeviceState& device, const GuardInput& input, double dt) noexcept {
  if (disarming_ || is_armed()) arming_for_ = -1.0;
  if (arming_for_ < 0.0) return;
  const GuardReason cause = obstacle(device, input);
  if (cause == GuardReason::none) {
    arming_for_ = -1.0;
    ramp_from_zero();
    report(GuardReason::armed);
    return;
  }
  arming_for_ += dt;
  if (arming_for_ <= settings_.arming_patience) return;
  arming_for_ = -1.0;
  report(GuardReason::refused, input.wanted.force.norm(), settings_.arming_force, cause, device.fault);
}

// 1 inside the usable box, down to 0 ten millimetres outside.
double HandGuard::workspace_share(const Vec3& position) noexcept {
  if (settings_.workspace_low.isZero(0.0) && settings_.workspace_high.isZero(0.0)) return 1.0;
  const Vec3 inside = position.cwiseMax(settings_.workspace_low).cwiseMin(settings_.workspace_high);
  const double outside = (position - inside).norm();
  if (outside == 0.0) return 1.0;
  limit_by(GuardReason::workspace, outside, 0.0);
  return std::max(0.0, 1.0 - outside / workspace_margin);
}

// Share of the bound: the continuous force from `hot` on, 0 at 1.
double HandGuard::heat_share(double temperature) noexcept {
  if (!(temperature > warm)) return 1.0;  // also for devices without a thermometer
  limit_by(GuardReason::hot, temperature, warm);
  const double continuous = std::min(1.0, settings_.continuous_force / std::max(bound(), 1e-9));
  if (temperature <= hot) return 1.0 + (temperature - warm) / (hot - warm) * (continuous - 1.0);
  return continuous * std::clamp((1.0 - temperature) / (1.0 - hot), 0.0, 1.0);
}

void HandGuard::fade(double dt) noexcept {
  faded_ = std::min(1.0, faded_ + dt / settings_.fade_time);
  // Zero is zero: rounding of the share must not leave a femtonewton.
  applied_ = faded_ < 1.0 - 1e-9 ? scaled(fading_, 1.0 - faded_) : Wrench{};
}

// Called while armed: from the requested force to the sent one.
void HandGuard::apply(const DeviceState& device, const GuardInput& input, double dt) noexcept {
  const double step = std::min(dt, 2.0 * settings_.dt);  // a late tick does not allow a larger step
  if (state_ == GuardState::ramping) {
    ramp_ += step / settings_.ramp_time;
    if (ramp_ >= 1.0) {
      ramp_ = 1.0;
      state_ = GuardState::active;
      report(GuardReason::full_force);
    }
  }
  Wrench wanted;
  if (state_ == GuardState::holding) {
    const double share = std::clamp(1.0 - (input.age - decay_after) / decay_time, 0.0, 1.0);
    if (share < 1.0) limit_by(GuardReason::stale_decay, input.age, decay_after);
    wanted = scaled(held_, share);
  } else {
    wanted = scaled(input.wanted, ramp_ * reduction_.share());
  }
  const double inside = workspace_share(device.hand.translation());
  const Vec3 desired = inside * wanted.force;
  // Damping does not delay a force on its way to zero.
  const double alive = state_ == GuardState::holding ? 0.0 : ramp_ * reduction_.share() * inside;
  // Damps the oscillation of the hand, or of the tool's rotation as motion of the end of its lever.
  const double calmed = calming_damping();
  const bool turns = reduction_.oscillation().turns && settings_.peak_torque > 0.0;
  const Vec3 turn_damping = (turns ? alive * calmed * lever * lever : 0.0) * motion_.recent_turning();
  wanted = {passivity_.damped(desired, motion_.recent_velocity(), dt, alive, turns ? 0.0 : calmed),
            inside * wanted.torque - turn_damping};
  damped_ = wanted.force - desired;
  if (!passivity_.damping().isZero(0.0) && !reduction_.damps())
    limit_by(GuardReason::passivity, passivity_.energy().minCoeff(), 0.0);
  carried_ = input.weight * alive;
  wanted.force += carried_;

  const double most = bound();
  const double thermal =
      most > 0.0 ? thermal_bound(mean_square_, std::min(settings_.continuous_force, most), most) : 0.0;
  const double heated = std::min(thermal, most * heat_share(device.temperature));

  const ForceChange slowed = approach(applied_.force, wanted.force, settings_.slew * step);
  if (slowed.limited) limit_by(GuardReason::slew, wanted.force.norm(), settings_.slew);
  const ForceChange clamped = shortened(slowed.value, most);
  if (clamped.limited) limit_by(GuardReason::peak, slowed.value.norm(), most);
  const ForceChange cooled = shortened(clamped.value, heated);
  if (cooled.limited && thermal <= heated) limit_by(GuardReason::thermal, clamped.value.norm(), thermal);
  applied_.force = cooled.value;
  // Damping removed by a limit has no effect.
  if (slowed.limited || clamped.limited || cooled.limited) damped_.setZero();

  // Motors too hot for a force are too hot for a torque.
  const double torque_most = peak_share * settings_.peak_torque * (most > 0.0 ? heated / most : 0.0);
  const ForceChange turned = approach(applied_.torque, wanted.torque, settings_.torque_slew * step);
  if (turned.limited) limit_by(GuardReason::slew, wanted.torque.norm(), settings_.torque_slew);
  const ForceChange shorter = shortened(turned.value, torque_most);
  // A device without torques lacks them, which is no fault.
  if (shorter.limited && settings_.peak_torque > 0.0) {
    limit_by(GuardReason::torque_peak, turned.value.norm(), torque_most);
  }
  applied_.torque = shorter.value;
}

const Wrench& HandGuard::step(const DeviceState& device, const GuardInput& input) noexcept {
  const double dt = input.dt > 0.0 ? std::min(input.dt, longest_dt) : settings_.dt;
  events_.clear();
  limits_ = 0;
  ++tick_;
  time_ += dt;

  held_force_ = sent_force_.step(dt);
  held_damping_ = sent_damping_.step(dt);
  watch(device, input, dt);
  passivity_.observe(held_force_, motion_.moved(), dt);
  try_to_arm(device, input, dt);
  disarming_ = false;
  if (is_armed()) {
    apply(device, input, dt);
  } else {
    carried_.setZero();
    damped_.setZero();
    fade(dt);
  }
  sent_force_.command(applied_.force - carried_);
  sent_damping_.command(damped_);
  mean_square_ += std::min(1.0, dt / settings_.thermal_time) * (applied_.force.squaredNorm() - mean_square_);
  return applied_;
}

}  // namespace bodkin::haptics
