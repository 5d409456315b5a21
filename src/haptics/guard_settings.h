#pragma once

#include <limits>

#include "core/geometry.h"
#include "haptics/device.h"

namespace bodkin::haptics {

// What HandGuard allows. guard_settings() makes it from what a device reports; the other numbers are choices of this
// project (docs/safety.md gives reasons).
struct GuardSettings {
  double dt = 0.001;                                            // s, the nominal period
  double peak_force = 0.0;                                      // N; 0 = the device renders no force
  double continuous_force = 0.0;                                // N, <= peak
  double peak_torque = 0.0;                                     // N mm; 0 = it renders no torque
  double user_force = std::numeric_limits<double>::infinity();  // N that the user wants at most
  Vec3 workspace_low = Vec3::Zero();                            // mm, both zero = unknown: no guard
  Vec3 workspace_high = Vec3::Zero();                           // mm
  double slew = 500.0;                                          // N/s by which a force may rise or turn
  double torque_slew = 20000.0;                                 // N mm/s
  double ramp_time = 1.0;                                       // s from armed to full force
  double fade_time = 0.020;                                     // s to zero where the device itself is sound
  double arming_force = 0.3;                                    // N that may wait at most when it is armed
  double arming_patience = 2.0;                                 // s for which a wish to arm stands
  double speed_limit = 1000.0;                                  // mm/s
  double frozen_time = 0.5;                                     // s of unchanged readings under force; 0 = no guard
  double oscillation_amplitude = 0.05;                          // mm from turning point to turning point
  double stiffness = 1.0;                                       // N/mm that the device renders stably
  double damping = 0.002;                                       // N s/mm that the device renders stably
  double thermal_time = 30.0;                                   // s over which the motors average their load
};

// Limits for a device: nine tenths of its peaks, its continuous force (15 % of the peak where it is unknown: less
// than of any device in share/bodkin/devices.csv), its workspace, amplitudes that its encoders can tell from noise.
// `rate`: Hz at which the guard is called.
GuardSettings guard_settings(const DeviceAbilities& abilities, double rate);

// Throws InputError naming the first number that cannot be: limits must be finite and > 0, the box must not be turned
// inside out.
void check(const GuardSettings& settings);

}  // namespace bodkin::haptics
