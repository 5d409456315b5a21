#pragma once

#include <cstdint>

#include "core/geometry.h"
#include "haptics/passivity_controller.h"

namespace bodkin::haptics {

// Reasons why the applied force differs from the requested one; bits of TickOutput::limits.
namespace force_limit {
inline constexpr std::uint8_t passivity = 1;   // damping was added to keep the tissue passive
inline constexpr std::uint8_t slew = 2;        // the force rose or turned faster than allowed
inline constexpr std::uint8_t peak = 4;        // the device's peak
inline constexpr std::uint8_t thermal = 8;     // the motors' mean load
inline constexpr std::uint8_t ramp = 16;       // the force is ramped up slowly after a start or reset
inline constexpr std::uint8_t fault = 32;      // faded to zero, until reset
inline constexpr std::uint8_t stiffness = 64;  // the tissue is stiffer than the device renders stably (a warning)
}  // namespace force_limit

// Limits of a device's force.
struct GovernorSettings {
  double dt = 0.001;                // s
  double peak_force = 6.0;          // N
  double continuous_force = 2.0;    // N, <= peak
  double peak_torque = 188.0;       // N mm; 0 = the device renders no torques
  double velocity_threshold = 0.5;  // mm/s, below which velocities are noise
  double slew = 200.0;              // N/s
  double ramp_slew = 20.0;          // N/s, while the force is ramped up
  double torque_slew = 8000.0;      // N mm/s; while the force is ramped up, a tenth of it
  double damping_limit = 0.03;      // N s/mm, largest damping that the passivity controller may add
  double thermal_time = 10.0;       // s, over which the motors average their load
  double fade = 0.030;              // s, to zero after a fault
};

// The request of the models in one tick. All forces act on the hand.
struct ForceRequest {
  double resistance = 0.0;    // N along the needle, positive pushes out
  Vec3 axis = Vec3::UnitZ();  // unit, hub to tip: the resistance acts along -axis
  double velocity = 0.0;      // mm/s along the axis, inwards
  bool in_contact = false;
  Vec3 constraint = Vec3::Zero();    // N
  Vec3 compensation = Vec3::Zero();  // N, weight of the device
  Vec3 torque = Vec3::Zero();        // N mm about the tip
};

// The last step of the simulated tick: passivity, then slew, then peak, then thermal limit, in this order. Slew, peak
// and thermal limits act on the vector's magnitude and keep its direction; torques have a slew and a peak of their
// own. Changes towards zero are never delayed. A limit that acts sets its flag. step() is noexcept, allocates nothing
// and returns a finite force of at most the peak for any input.
//
// Division of work with HandGuard (haptics/hand_guard.h): the governor belongs to the simulation. It knows the
// tissue's force and the needle's axis, so passivity is its task, and its limits are those of the device for which
// the case was made. It is deterministic and part of every recording, including those of simulated hands. The guard
// belongs to a real device: it knows nothing of tissue, acts after the governor as the last exit to the motors,
// enforces the limits that this very device reports, and handles what only a device has: arming, dead-man,
// temperature, workspace, speed, late ticks. Shared functions are in haptics/force_change.h.
class ForceGovernor {
 public:
  explicit ForceGovernor(const GovernorSettings& settings);

  // The applied force, N; torque() is the torque applied with it, N mm.
  Vec3 step(const ForceRequest& request) noexcept;
  const Vec3& torque() const noexcept { return torque_; }
  // After a fault: from now on the force fades to zero, in `fade` seconds, until reset().
  void fail() noexcept;
  void reset() noexcept;

  bool failed() const noexcept { return failed_; }
  std::uint8_t flags() const noexcept { return flags_; }  // of the last step
  const PassivityController& passivity() const noexcept { return passivity_; }
  double mean_square() const noexcept { return mean_square_; }  // N^2, over thermal_time

 private:
  Vec3 limit_slew(const Vec3& wanted) noexcept;
  void step_torque(const Vec3& wanted) noexcept;
  Vec3 limit_size(const Vec3& force, double size, std::uint8_t flag) noexcept;

  GovernorSettings settings_;
  PassivityController passivity_;
  Vec3 applied_ = Vec3::Zero();    // N, of the last step
  Vec3 torque_ = Vec3::Zero();     // N mm, of the last step
  Vec3 fade_step_ = Vec3::Zero();  // N per tick after a fault
  Vec3 fade_turn_ = Vec3::Zero();  // N mm per tick after a fault
  double mean_square_ = 0.0;
  std::uint8_t flags_ = 0;
  bool ramping_ = true;
  bool failed_ = false;
};

}  // namespace bodkin::haptics
