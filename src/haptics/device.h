#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/geometry.h"

namespace bodkin::haptics {

// The operator's frame, in which every device communicates with Bodkin: right-handed, +X to the operator's right, +Y
// away from the operator, +Z up, origin in the middle of the device's workspace, mm. A vendor's own axes and units
// exist only in its driver.

// Faults of a device. After any of them the force goes to zero until the hand is armed again.
enum class DeviceFault : std::uint8_t {
  none,
  not_installed,   // the vendor's library or service does not exist
  not_connected,   // the device is not connected
  not_calibrated,  // the device does not know its position
  busy,            // another program uses it
  no_permission,
  wrong_version,       // of the vendor's library or service
  communication_lost,  // unplugged, or no longer responding
  overheated,
  force_limit,
  velocity_limit,
  emergency_stop,
  bad_data,  // a pose that is not finite or not possible
  vendor_error
};

// "communication lost"
std::string_view text_of(DeviceFault fault) noexcept;

// The abilities of a device, from its driver or its profile. 0: unknown.
struct DeviceAbilities {
  std::string name;                      // of the model: "Touch"
  std::string serial;                    // may be empty
  double peak_force = 0.0;               // N; 0 = the device renders no force
  double continuous_force = 0.0;         // N
  double peak_torque = 0.0;              // N mm; 0 = it renders no torque
  double stiffness = 0.0;                // N/mm, rendered stably
  double damping = 0.0;                  // N s/mm, rendered stably; 0 = unknown
  double resolution = 0.0;               // mm
  double rate = 1000.0;                  // Hz
  double delay = 0.0;                    // s from sending a force to the force at the hand, as stated by its driver
  std::string delay_source;              // source of that statement, one sentence; empty = not stated
  std::optional<double> measured_delay;  // s, as measured by `bodkin devices calibrate`
  Vec3 workspace_low = Vec3::Zero();     // mm, operator's frame; both zero = unknown
  Vec3 workspace_high = Vec3::Zero();    // mm
  bool measures_rotation = false;
  bool has_dead_man = false;  // it can detect the hand that holds it
  bool owns_loop = false;     // the vendor's thread calls our tick
};

// One reading of a device.
struct DeviceState {
  Pose hand = Pose::Identity();  // the tool in the operator's frame, mm; third axis hub to tip
  Vec3 velocity = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());  // mm/s; NaN = not reported
  std::uint32_t buttons = 0;                                                 // bit n: button n is pressed
  bool held = true;          // the dead-man's switch, true for a device without one
  double temperature = 0.0;  // of the motors, 0 cold to 1 hot
  DeviceFault fault = DeviceFault::none;

  // The hand has ended the session (BODKIN_BUTTON_END).
  bool ended() const noexcept { return (buttons >> 31U) != 0; }
  // Whether the pose of the hand is unknown (BODKIN_BUTTON_UNSEEN).
  bool unseen() const noexcept { return (buttons >> 30U & 1U) != 0; }
};

}  // namespace bodkin::haptics
