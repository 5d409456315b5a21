#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "haptics/device_servo.h"

namespace bodkin::station {

// Observations of the device.
struct DeviceObservation {
  double seconds = 0.0;
  std::uint64_t rounds = 0;
  haptics::ServoTimings timings;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());  // mm, operator's frame
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
  std::uint32_t buttons = 0;  // those pressed
  double hottest = 0.0;
  double released = 0.0;  // s without a hand, if the device can detect it
  haptics::DeviceFault fault = haptics::DeviceFault::none;
  std::string sentence;
  double strongest = 0.0;  // N applied; must be 0
  bool answered = true;    // it could be stopped

  double rate() const { return static_cast<double>(rounds) / seconds; }
};

// Runs a device for this time without requesting forces, and records its behaviour. `servo` must have been created
// for this: its controller requests no force. `watch` is called every 10 ms with the s elapsed; false ends the check.
// Throws SystemError when the device cannot be started.
DeviceObservation observe_device(haptics::DeviceServo& servo, double seconds,
                                 const std::function<bool(double elapsed)>& watch);

// Empty when the device is ready; else the obstacle, one sentence with the remedy.
std::string why_not_ready(const DeviceObservation& seen, const haptics::DeviceAbilities& abilities);

}  // namespace bodkin::station
