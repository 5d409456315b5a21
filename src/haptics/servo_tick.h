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

namespace bodkin::haptics {

// Input of a controller, once per tick.
struct ControlInput {
  Pose needle = Pose::Identity();  // LPS
  double dt = 0.0;                 // s since the last tick, as measured
  std::uint64_t tick = 0;
  std::uint32_t buttons = 0;
  bool needle_held = false;  // frozen or clutched: no hand holds the needle, and the hand feels no force
  GuardState guard = GuardState::disarmed;  // after the previous tick: whether the hand will feel the answer
};

// Output of a controller.
struct Control {
  Wrench wrench;     // on the hand that holds the needle: LPS, N, N mm about the tip
  double age = 0.0;  // s since the underlying state was computed; 0 = in this tick
  // Motion by which tissue carries a held needle until the next tick: of its tip (mm, LPS), and of its axes, about
  // the tip; ignored for a needle in a hand.
  Vec3 carried = Vec3::Zero();
  Mat3 turned = Mat3::Identity();
};

// Any function from a needle's pose to a wrench: tissue, a spring, nothing. Called once per tick, in the servo's
// thread: must not allocate, lock or wait. An exception ends the force, and it is not called again until the next arm
// command.
using Controller = std::function<Control(const ControlInput&)>;

struct ServoSettings {
  double rate = 1000.0;  // Hz; 200 to 4000
  GuardSettings guard;   // its dt is set from the rate
  WorkspaceSettings workspace;
  double weight = 0.0;       // N of the device's handle that its own controller does not carry; 0 to 5
  double grasp_time = 0.25;  // s over which the force returns after a freeze or clutch
  // Buttons of the device, by number; -1 = none.
  int dead_man_button = -1;  // in addition to the device's own switch; releasing it ends the force
  int clutch_button = -1;    // held while the hand is moved back
  int freeze_button = -1;    // pressed once to freeze, once more to grasp again
};

// One round of the servo as a plain function of the device's report: commands, workspace, controller, guard,
// snapshot. It does not depend on the thread that runs it: ours (ServoThread) or a vendor's. step() is noexcept,
// allocates nothing, locks nothing and never waits.
//
// Threads: step() belongs to one thread. command() belongs to another, and everything under "observer" to a third;
// the last two may be the same. disarm() is for all threads. Every exchange is wait-free on both sides.
class ServoTick {
 public:
  // Throws InputError for out-of-range settings or an empty controller.
  ServoTick(const ServoSettings& settings, Controller controller, TickClock clock = monotonic_clock());

  // The wrench for the hand, operator's frame. `dt`: measured s since the last call. `lateness`: s by which this tick
  // began late; by default the excess of dt over the period.
  Wrench step(const DeviceState& device, double dt,
              double lateness = std::numeric_limits<double>::quiet_NaN()) noexcept;

  // False when the queue is full and the command was dropped. Commands take effect in order, in the next tick.
  bool command(const ServoCommand& command) noexcept { return commands_.push(command); }
  // Ends the force at the next tick, regardless of queued commands.
  void disarm() noexcept { disarm_.store(true, std::memory_order_release); }

  // Observer: the newest tick.
  const ServoSnapshot& snapshot() noexcept { return snapshots_.read(); }
  // Observer: the newest timings, published every hundred ticks.
  const ServoTimings& timings() noexcept { return published_timings_.read(); }
  // Observer: the next event of the guard; false when the queue is empty.
  bool next_event(GuardEvent& event) noexcept { return events_.pop(event); }
  // Observer: the newest fault with the preceding ticks; count is 0 without a fault.
  const FaultReport& fault_report() noexcept { return reports_.read(); }

  double period() const noexcept { return period_; }

 private:
  // A debounced button: a change counts after 20 ms.
  struct Button {
    int number = -1;
    bool down = false;
    double changed_for = 0.0;                              // s
    bool step(std::uint32_t buttons, double dt) noexcept;  // true in the tick in which it changed
  };

  void apply_commands() noexcept;
  void follow_buttons(const DeviceState& device, double dt) noexcept;
  Control control(const ControlInput& input) noexcept;
  void record_sample(const ServoSample& sample) noexcept;
  void publish_snapshot(const DeviceState& device, const Control& control) noexcept;
  void record_timing(double lateness, double compute) noexcept;

  double period_;
  double grasp_time_;
  Vec3 weight_;  // N, upwards
  int dead_man_button_;
  Controller controller_;
  TickClock clock_;
  WorkspaceMap map_;
  HandGuard guard_;
  Button clutch_button_, freeze_button_;
  Pose hand_ = Pose::Identity();  // the last plausible pose
  bool seen_ = false;             // hand_ has been set
  double grasp_ = 1.0;            // fraction of the force after a hold
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
};

}  // namespace bodkin::haptics
