#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "haptics/device.h"

namespace bodkin::haptics {

// State of HandGuard.
enum class GuardState : std::uint8_t {
  disarmed,  // no force until the user arms
  ramping,   // the force is ramped up
  active,
  holding,  // the simulation is late: the last force is held, then fades
  faulted   // no force until the user arms again
};

// "ramping"
std::string_view text_of(GuardState state) noexcept;

// Reasons for which HandGuard changes its state or the force.
enum class GuardReason : std::uint8_t {
  none,
  // changes of state on request
  armed,
  full_force,  // the ramp is complete
  disarmed,
  refused,      // arming failed: `cause` did not pass in time
  released,     // the dead-man's switch: force fades, disarmed
  tick_gap,     // no tick for too long: the force restarts from zero
  stale,        // the simulation is late: the force is held
  fresh_again,  // the simulation has resumed
  // faults: no force until the user arms again
  not_finite,         // the controller requested a force that is not finite
  stale_fault,        // the simulation has been late for too long
  controller_failed,  // the controller threw
  device_fault,       // see GuardEvent::device_fault
  bad_pose,           // the device reports a pose that is not a number
  jump,               // the device's pose jumped
  too_fast,
  frozen,       // the device's readings have stopped while it renders a force
  oscillation,  // again, soon after the force was halved because of it
  // limits
  passivity,  // an axis has given the hand more energy than it received: damping was added
  slew,
  peak,
  torque_peak,
  thermal,          // the mean load
  hot,              // the temperature that the device reports
  workspace,        // outside the usable workspace
  halved,           // oscillation: the force is halved
  damping,          // oscillation continues: a quarter of the force, with damping
  stale_decay,      // held for too long: the force fades
  moving,           // cause of `refused`: the hand is not at rest
  pulling,          // cause of `refused`: a force would act at once
  count_of_reasons  // not a reason
};

// "the dead-man's switch was released"
std::string_view text_of(GuardReason reason) noexcept;

// One action of HandGuard.
struct GuardEvent {
  std::uint64_t tick = 0;
  double time = 0.0;  // s since the guard started
  GuardReason reason = GuardReason::none;
  GuardReason cause = GuardReason::none;         // of a refusal
  DeviceFault device_fault = DeviceFault::none;  // if the device reports one
  GuardState state = GuardState::disarmed;       // afterwards
  double value = 0.0;                            // the value found, in the unit of the limit
  double limit = 0.0;                            // the allowed value; 0 if the reason has no number
};

// The events of one tick, in a fixed place.
class GuardEvents {
 public:
  static constexpr std::size_t capacity = 12;

  void clear() noexcept { size_ = 0; }
  void push(const GuardEvent& event) noexcept {
    if (size_ < capacity) events_[size_++] = event;
  }
  std::size_t size() const noexcept { return size_; }
  const GuardEvent& operator[](std::size_t index) const noexcept { return events_[index]; }
  const GuardEvent* begin() const noexcept { return events_.data(); }
  const GuardEvent* end() const noexcept { return events_.data() + size_; }

 private:
  std::array<GuardEvent, capacity> events_{};
  std::size_t size_ = 0;
};

}  // namespace bodkin::haptics
