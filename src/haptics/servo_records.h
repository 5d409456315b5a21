#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/geometry.h"
#include "haptics/device.h"
#include "haptics/guard_event.h"
#include "haptics/latency_histogram.h"

namespace bodkin::haptics {

// Input and output records of a servo tick, plain data of fixed size.

// A person's request to a running servo.
struct ServoCommand {
  enum class Kind : std::uint8_t { arm, disarm, freeze, unfreeze, clutch, unclutch, move_body };
  Kind kind = Kind::disarm;
  Vec3 middle = Vec3::Zero();        // move_body: LPS mm, point to be in the middle of the workspace
  Mat3 rotation = Mat3::Identity();  // move_body: operator's frame to patient
};

// The newest tick, for all threads but the servo's.
struct ServoSnapshot {
  std::uint64_t tick = 0;
  double time = 0.0;  // s since the servo began, the sum of its periods
  DeviceState device;
  Pose needle = Pose::Identity();  // LPS
  Wrench wanted;                   // on the needle, LPS, from the controller
  Wrench applied;                  // on the hand, operator's frame, after the guard
  GuardState state = GuardState::disarmed;
  GuardReason fault = GuardReason::none;
  std::uint32_t limits = 0;    // see HandGuard::limits
  Vec3 energy = Vec3::Zero();  // N mm given by the hand since it was armed, by axis of the operator's frame
  bool frozen = false;
  bool clutched = false;
};

// Timing statistics of the servo.
struct ServoTimings {
  LatencyHistogram lateness;   // s by which ticks began later than their period
  LatencyHistogram compute;    // s that a tick took
  std::uint64_t overruns = 0;  // ticks that began more than a period late, or took longer than one
  std::uint64_t ticks = 0;
  double recent_success = 1.0;  // fraction of the last hundred ticks without overrun
};

// One tick in a fault report: the input state and the resulting force.
struct ServoSample {
  std::uint64_t tick = 0;
  double dt = 0.0;        // s
  double lateness = 0.0;  // s
  double compute = 0.0;   // s until the wrench was known
  Vec3 position = Vec3::Zero();
  Vec3 wanted = Vec3::Zero();   // N, operator's frame, before the guard
  Vec3 applied = Vec3::Zero();  // N, after it
  double temperature = 0.0;
  std::uint32_t buttons = 0;
  GuardState state = GuardState::disarmed;
  DeviceFault fault = DeviceFault::none;
  bool held = true;
};

// The ticks before a fault, oldest first, the one of the fault last.
struct FaultReport {
  static constexpr std::size_t most = 200;
  GuardEvent fault;
  std::size_t count = 0;
  std::array<ServoSample, most> ticks{};  // [0, count)
};

}  // namespace bodkin::haptics
