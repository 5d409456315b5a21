#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>

#include "core/latest_value.h"
#include "core/single_producer_ring.h"
#include "haptics/hand_guard.h"
#include "haptics/servo_records.h"
#include "haptics/tick_clock.h"
#include "haptics/workspace_map.h"

namespace bodkin {

// What a controller gets in a tick.
struct ControlInput {
  Pose needle = Pose::Identity();  // LPS
  double dt = 0.0;                 // s since the last tick, as measured
  std::uint64_t tick = 0;
  std::uint32_t buttons = 0;
  bool needle_held = false;                 // frozen or clutched: it stays where it is and no hand feels it
  GuardState guard = GuardState::disarmed;  // after the tick before: whether the hand will feel the answer
};

// What it answers.
struct Control {
  Wrench wrench;     // on the hand that would hold the needle: LPS, N, N mm about the tip
  double age = 0.0;  // s since what it rests on was computed; 0 when it was in this tick
};

// Anything that turns a needle's pose into a wrench: tissue, a spring, nothing. Called once a tick, in the servo's
// thread: must not allocate, lock or wait. What it throws ends the force, and it is not called again until the next
// arm.
using Controller = std::function<Control(const ControlInput&)>;

struct ServoSettings {
  double rate = 1000.0;  // Hz; 200 to 4000
  GuardSettings guard;   // its dt is set from the rate
  WorkspaceSettings workspace;
  double weight = 0.0;       // N of the device's handle that its own controller does not carry; 0 to 5
  double grasp_time = 0.25;  // s over which the force comes back when a hold ends
  // Buttons of the device, by number; -1 = none.
  int dead_man_button = -1;  // beside the device's own switch; the force ends when it is let go
  int clutch_button = -1;    // held while the hand goes back
  int freeze_button = -1;    // pressed once to freeze, once more to grasp again
};

// One round of the servo as a plain function of what the device reports: commands, workspace, controller, guard,
// snapshot. It does not know which thread runs it: ours (ServoThread) or a vendor's. step() is noexcept, allocates
// nothing, locks nothing and waits for nobody.
//
// Threads: step() belongs to one. command() belongs to one other, and everything under "observer" to one more; those
// two may be the same. disarm() is for all. Every exchange is wait-free on both sides.
class ServoTick {
 public:
  // Throws InputError for settings that cannot be and for a controller that is none.
  ServoTick(const ServoSettings& settings, Controller controller, TickClock clock = monotonic_clock());

  // The wrench for the hand, operator's frame. `dt`: s since the last call, as measured. `lateness`: s by which this
  // tick began late; not given: what dt is longer than the period.
  Wrench step(const DeviceState& device, double dt,
              double lateness = std::numeric_limits<double>::quiet_NaN()) noexcept;

  // False when so many commands wait that this one was not taken. Commands take effect in order, in the next tick.
  bool command(const ServoCommand& command) noexcept { return commands_.push(command); }
  // Ends the force at the next tick, whatever else waits.
  void disarm() noexcept { disarm_.store(true, std::memory_order_release); }

  // Observer: the newest tick.
  const ServoSnapshot& snapshot() noexcept { return snapshots_.read(); }
  // Observer: the newest timings; they are told every hundred ticks.
  const ServoTimings& timings() noexcept { return published_timings_.read(); }
  // Observer: the next thing that the guard did; false when there is none.
  bool next_event(GuardEvent& event) noexcept { return events_.pop(event); }
  // Events that nobody fetched in time.
  std::uint64_t lost_events() const noexcept { return lost_events_.load(std::memory_order_relaxed); }
  // Observer: the newest fault with the ticks before it; count is 0 when there was none.
  const FaultReport& fault_report() noexcept { return reports_.read(); }

  double period() const noexcept { return period_; }

 private:
  // A button that must have been as it is for 20 ms before it counts.
  struct Button {
    int number = -1;
    bool down = false;
    double changed_for = 0.0;                              // s
    bool step(std::uint32_t buttons, double dt) noexcept;  // true when it has just changed
  };

  void obey() noexcept;
  void follow_buttons(const DeviceState& device, double dt) noexcept;
  Control control(const ControlInput& input) noexcept;
  void keep(const ServoSample& sample) noexcept;
  void tell(const DeviceState& device, const Control& control) noexcept;
  void measure(double lateness, double compute) noexcept;

  double period_;
  double grasp_time_;
  Vec3 weight_;  // N, upwards
  int dead_man_button_;
  Controller controller_;
  TickClock clock_;
  WorkspaceMap map_;
  HandGuard guard_;
  Button clutch_button_, freeze_button_;
  Pose hand_ = Pose::Identity();  // the last one that could be
  bool seen_ = false;             // there was one
  double grasp_ = 1.0;            // share of the force after a hold
  bool controller_failed_ = false;
  std::uint64_t tick_ = 0;
  double time_ = 0.0;
  ServoTimings timings_;
  int recent_ = 0, recent_good_ = 0;
  std::array<ServoSample, FaultReport::most> samples_{};  // a ring
  FaultReport report_;

  SingleProducerRing<ServoCommand> commands_{64};
  SingleProducerRing<GuardEvent> events_{256};
  LatestValue<ServoSnapshot> snapshots_;
  LatestValue<ServoTimings> published_timings_;
  LatestValue<FaultReport> reports_;
  std::atomic<bool> disarm_{false};
  std::atomic<std::uint64_t> lost_events_{0};
};

}  // namespace bodkin
