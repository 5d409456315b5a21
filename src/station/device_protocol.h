#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/device_servo.h"

namespace bodkin::station {

// One action of a person with a device while it is observed without force, so that a remote reader can check that its
// driver's axes, units, buttons and faults match the device.
struct ProtocolStep {
  std::string_view name;        // "right"
  std::string_view task;        // instruction, one or two sentences
  Vec3 towards = Vec3::Zero();  // unit, operator's frame: direction of the motion; zero: none
};

// The step that provokes a fault.
inline constexpr std::string_view last_protocol_step = "faults";

// The steps that a device allows, in their order.
std::vector<ProtocolStep> protocol_steps(const haptics::DeviceAbilities& device);

// A fault that occurred during a step.
struct ProtocolFault {
  double at = 0.0;  // s since the step began
  haptics::DeviceFault fault = haptics::DeviceFault::none;
  std::string sentence;  // the driver's, may be empty
};

// Observations in a step. Lengths mm, operator's frame.
struct ProtocolFinding {
  std::string name;
  double seconds = 0.0;
  std::uint64_t rounds = 0;                               // of the loop
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();            // mean of the first and of the last tenth
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();           // the box of all readings
  Vec3 spread = Vec3::Zero();                             // standard deviation
  Vec3 smallest = Vec3::Zero();                           // change between two readings, 0 = none changed
  Vec3 axis_from = Vec3::Zero(), axis_to = Vec3::Zero();  // of the tool, first and last reading
  std::uint32_t buttons = 0;                              // those pressed
  double released = 0.0;                                  // s without a hand, if the device detects it
  double hottest = 0.0;                                   // motor, 0 to 1
  double strongest = 0.0;                                 // N applied, must be 0
  std::vector<ProtocolFault> faults;
  std::string against;  // the deviation found, one sentence; may be empty
};

// Observes a running servo that requests no force. `watch` is called every 2 ms with the s elapsed; false ends the
// step.
ProtocolFinding observe_step(haptics::DeviceServo& servo, const haptics::DeviceAbilities& device,
                             const ProtocolStep& step, double seconds,
                             const std::function<bool(double elapsed)>& watch);

}  // namespace bodkin::station
