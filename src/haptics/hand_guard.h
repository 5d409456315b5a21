#pragma once

#include <array>
#include <cstdint>

#include "core/geometry.h"
#include "haptics/axis_passivity.h"
#include "haptics/device.h"
#include "haptics/force_reduction.h"
#include "haptics/guard_event.h"
#include "haptics/guard_settings.h"
#include "haptics/held_force.h"
#include "haptics/motion_watch.h"
#include "haptics/oscillation_watch.h"
#include "haptics/round_trip_watch.h"
#include "haptics/swing_watch.h"

namespace bodkin::haptics {

// Whether the pose is plausible: finite, a proper rotation, and within 5 m of the workspace.
bool is_possible(const Pose& hand) noexcept;

// Input of one tick.
struct GuardInput {
  Wrench wanted;     // on the hand, operator's frame
  double age = 0.0;  // s since the simulation computed it
  double dt = 0.0;   // s since the previous tick
  bool controller_failed = false;
  Vec3 weight = Vec3::Zero();  // N, carries the device's handle: part of the force, not of the passivity account
};

// The last exit to the motors of a real device, for as long as a hand holds it. It knows nothing of tissue: it takes
// the wrench that a controller wants and what the device reports, and passes on a wrench that cannot hurt. The result
// is always finite and never above the peaks; a change towards zero is never delayed; every intervention is an event
// with its reason. step() is noexcept, allocates nothing, locks nothing and reads no clock. ForceGovernor
// (haptics/force_governor.h) acts before it, inside the simulation, and enforces passivity and the case's limits; its
// header says how the two divide the work.
//
//   disarmed --arm(), hand at rest--> ramping --1 s--> active <--late, fresh again--> holding
//   any of these --dead-man released, disarm()--> disarmed;  --anything wrong--> faulted --arm()--> ramping
//
// The force drops to zero at once when the device itself is in doubt (its own faults, a pose that is not finite, a
// jump, excessive speed); it ramps linearly to zero in 20 ms when the device works (dead-man, disarm(), a force that
// is not finite, frozen readings, a hand that shakes after half and a quarter of the force). While the simulation is
// more than 5 ms late the last force is held; it fades from 15 to 45 ms of age, and at 50 ms it is a fault.
class HandGuard {
 public:
  // Throws InputError as check() does.
  explicit HandGuard(const GuardSettings& settings);

  // All functions are for the thread that calls step(), which others reach through ServoTick's commands.
  //
  // Requests forces. They begin at the first tick, within 2 s, at which the hand has been at rest for 50 ms, holds
  // the dead-man's switch, and the wanted force is small; otherwise the request is refused.
  void arm() noexcept { arming_for_ = 0.0; }
  // Ends forces at the user's request.
  void disarm() noexcept { disarming_ = true; }

  // The applied wrench, on the hand, operator's frame.
  const Wrench& step(const DeviceState& device, const GuardInput& input) noexcept;

  GuardState state() const noexcept { return state_; }
  bool is_armed() const noexcept { return state_ != GuardState::disarmed && state_ != GuardState::faulted; }
  // The reason of the fault; none without a fault.
  GuardReason fault() const noexcept { return fault_; }
  const Wrench& applied() const noexcept { return applied_; }     // of the last step
  const GuardEvents& events() const noexcept { return events_; }  // of the last step
  // Bit n: GuardReason n limited the wrench of the last step.
  std::uint32_t limits() const noexcept { return limits_; }
  double mean_square() const noexcept { return mean_square_; }    // N^2
  double speed() const noexcept { return motion_.mean_speed(); }  // mm/s, over 10 ms
  // N mm that the hand has given along each axis of the operator's frame up to the last reading, see AxisPassivity.
  const Vec3& energy() const noexcept { return passivity_.energy(); }
  // N, upper bound of every force, apart from motor heat.
  double bound() const noexcept;

 private:
  // Range within a window, and its change in the last one on the axis with the largest change.
  struct Range {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    double last = 0.0;
  };
  static constexpr auto reasons = static_cast<std::size_t>(GuardReason::count_of_reasons);

  void watch(const DeviceState& device, const GuardInput& input, double dt) noexcept;
  void watch_hand(double dt) noexcept;
  Oscillation find_oscillation(double dt) noexcept;
  void watch_oscillation(double dt) noexcept;
  void watch_range(double dt) noexcept;
  void calm(ForceReduction::Step step) noexcept;
  double calming_damping() const noexcept;
  void watch_age(double age) noexcept;
  void try_to_arm(const DeviceState& device, const GuardInput& input, double dt) noexcept;
  GuardReason obstacle(const DeviceState& device, const GuardInput& input) const noexcept;
  void apply(const DeviceState& device, const GuardInput& input, double dt) noexcept;
  double workspace_share(const Vec3& position) noexcept;
  double heat_share(double temperature) noexcept;
  void fade(double dt) noexcept;

  void report(GuardReason reason, double value = 0.0, double limit = 0.0, GuardReason cause = GuardReason::none,
              DeviceFault fault = DeviceFault::none) noexcept;
  void limit_by(GuardReason reason, double value, double limit) noexcept;
  void fail(GuardReason reason, double value = 0.0, double limit = 0.0,
            DeviceFault fault = DeviceFault::none) noexcept;
  void release(GuardReason reason) noexcept;
  void end_force(bool at_once) noexcept;
  void ramp_from_zero() noexcept;

  GuardSettings settings_;
  MotionWatch motion_;
  OscillationWatch fast_, driven_, slow_;
  RoundTripWatch round_trips_;
  SwingWatch swings_, turns_;  // of the hand's position, and of its orientation as the motion of a point on a lever
  ForceReduction reduction_;
  GuardState state_ = GuardState::disarmed;
  GuardReason fault_ = GuardReason::none;
  GuardEvents events_;
  std::uint32_t limits_ = 0;
  std::uint64_t tick_ = 0;
  double time_ = 0.0;                      // s
  std::array<double, reasons> limited_{};  // s, when each reason last limited
  Wrench applied_;
  AxisPassivity passivity_;
  HeldForce sent_force_, sent_damping_;  // without the handle's weight; the damping within it
  Vec3 held_force_ = Vec3::Zero();       // N, actually held since the previous tick, without the handle's weight
  Vec3 held_damping_ = Vec3::Zero();     // N, damping within it
  double unpushed_for_ = 0.0;            // s without force
  Vec3 carried_ = Vec3::Zero();          // N, weight within the force of the last step
  Vec3 damped_ = Vec3::Zero();           // N, damping within it
  Wrench held_;                          // held while the simulation is late
  Wrench fading_;                        // start of the ramp to zero
  double faded_ = 1.0;                   // fraction of the ramp to zero completed
  double ramp_ = 0.0;                    // fraction of the force that is passed on
  double mean_square_ = 0.0;             // N^2
  double arming_for_ = -1.0;             // s since the request to arm; negative: none is pending
  Range force_range_, torque_range_;     // N held, N mm
  double window_for_ = 0.0;              // s
  bool disarming_ = false;
  double resting_for_ = 0.0;                      // s
  double still_for_ = 0.0;                        // s of unchanged readings under force
  DeviceFault device_fault_ = DeviceFault::none;  // of the last step, a pose that cannot be included
  int fast_ticks_ = 0;
};

}  // namespace bodkin::haptics
