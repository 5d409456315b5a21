#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "haptics/deadline_clock.h"
#include "haptics/device_port.h"
#include "haptics/servo_thread.h"
#include "haptics/servo_tick.h"

namespace bodkin::haptics {

// An open device with its servo, whoever owns the loop: a vendor's thread, or one of ours. Without start() and an arm
// command no force leaves.
class DeviceServo {
 public:
  // `known`: what the device can do, by itself and by its profile (haptics/device_profiles.h). The guard of
  // `settings` is made for it, but for the user's limit and the time for which readings may stand still. Throws
  // InputError as ServoTick does.
  DeviceServo(DevicePort port, const DeviceAbilities& known, const ServoSettings& settings, Controller controller);
  ~DeviceServo();  // stop()
  DeviceServo(const DeviceServo&) = delete;
  DeviceServo& operator=(const DeviceServo&) = delete;

  // The loop runs from now on, ahead of other programs where the system grants that: a thread of ours, or the
  // vendor's. Throws DeviceError, or SystemError when real-time priority is required and refused. Once only.
  void start(bool require_real_time = false);
  // Ramps the force to zero and ends the loop. A loop whose ticks do not come any more is not waited for longer than
  // 40 ms, and one whose ticks come slowly not longer than 120 ms, before it ends without a ramp. False: the device
  // did not answer and was left behind, never waited for.
  bool stop() noexcept;

  // Commands, snapshots, events and timings.
  ServoTick& tick() noexcept;
  // Rounds so far. Any thread.
  std::uint64_t rounds() const noexcept;
  // s from a tick to the moment at which its command is sent: 0 where the vendor owns the loop, else a period.
  double own_delay() const noexcept;
  // What the system did not grant, one sentence each; known once start() has returned.
  const std::vector<std::string>& refused() const noexcept { return refused_; }
  // One sentence about the device's last fault; may be empty.
  std::string explain() const;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;        // with a loop that may have to be left behind
  std::unique_ptr<ServoThread> thread_;   // where the loop is ours
  std::unique_ptr<LockedMemory> memory_;  // while a vendor's loop runs
  std::vector<std::string> refused_;
  bool started_ = false;
};

}  // namespace bodkin::haptics
