#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "haptics/device.h"

namespace bodkin::haptics {

// What HandGuard is doing.
enum class GuardState : std::uint8_t {
  disarmed,  // no force until the user arms
  ramping,   // the force is being brought in
  active,
  holding,  // the simulation is late: the last force is held, then fades
  faulted   // no force until the user arms again
};

// "ramping"
std::string_view text_of(GuardState state) noexcept;

// Why HandGuard changed its state or the force.
enum class GuardReason : std::uint8_t {
  none,
  // changes of state on request
  armed,
  full_force,  // the ramp is over
  disarmed,
  refused,      // was to be armed, but `cause` did not pass in time
  released,     // the dead-man's switch: force fades, disarmed
  tick_gap,     // no tick for too long: the force starts again from zero
  stale,        // the simulation is late: the force is held
  fresh_again,  // and has come back
  // faults: no force until the user arms again
  not_finite,         // the controller asked for a force that is not a number
  stale_fault,        // the simulation has been silent for too long
  controller_failed,  // the controller threw
  device_fault,       // see GuardEvent::device_fault
  bad_pose,           // the device reports a pose that is not a number
  jump,               // the device's pose jumped
  too_fast,
  frozen,       // the device's readings have stopped while it pushes
  oscillation,  // again, soon after the force was halved for it
  // limits
  passivity,  // an axis has given the hand more energy than it took: damping was added
  slew,
  peak,
  torque_peak,
  thermal,          // the mean load
  hot,              // the temperature that the device reports
  workspace,        // outside the usable workspace
  halved,           // oscillation: the force is halved
  damping,          // it goes on: a quarter of the force, with damping
  stale_decay,      // held for too long: the force fades
  moving,           // cause of `refused`: the hand is not at rest
  pulling,          // cause of `refused`: a force would act at once
  count_of_reasons  // not a reason
};

// "the dead-man's switch was released"
std::string_view text_of(GuardReason reason) noexcept;

// One thing that HandGuard did.
struct GuardEvent {
  std::uint64_t tick = 0;
  double time = 0.0;  // s since the guard began
  GuardReason reason = GuardReason::none;
  GuardReason cause = GuardReason::none;         // of a refusal
  DeviceFault device_fault = DeviceFault::none;  // where the device says so
  GuardState state = GuardState::disarmed;       // afterwards
  double value = 0.0;                            // what was found, in the unit of the limit
  double limit = 0.0;                            // what is allowed; 0 where the reason has no number
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
