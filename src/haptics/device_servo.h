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

// An open device with its servo, whoever owns the loop: a vendor's thread, or ours. It sends no force before start()
// and an arm command.
class DeviceServo {
 public:
  // `known`: the device's abilities, as reported and from its profile (haptics/device_profiles.h). They determine the
  // guard of `settings`, except for the user's limit and the time for which readings may stand still. Throws
  // InputError as ServoTick does.
  DeviceServo(DevicePort port, const DeviceAbilities& known, const ServoSettings& settings, Controller controller);
  ~DeviceServo();  // stop()
  DeviceServo(const DeviceServo&) = delete;
  DeviceServo& operator=(const DeviceServo&) = delete;

  // Starts the loop, with priority over other programs if the system grants it: on a thread of ours, or on the
  // vendor's. Throws DeviceError, or SystemError when real-time priority is required and refused. Once only.
  void start(bool require_real_time = false);
  // Ramps the force to zero and ends the loop. If ticks have stopped it waits at most 40 ms, if they come slowly at
  // most 120 ms, before ending without a ramp. False: the device did not respond and was abandoned.
  bool stop() noexcept;

  // Commands, snapshots, events and timings.
  ServoTick& tick() noexcept;
  // Rounds so far. Any thread.
  std::uint64_t rounds() const noexcept;
  // s from a tick to the sending of its command: 0 if the vendor owns the loop, else a period.
  double own_delay() const noexcept;
  // Requests that the system refused, one sentence each; known once start() has returned.
  const std::vector<std::string>& refused() const noexcept { return refused_; }
  // One sentence about the device's last fault; may be empty.
  std::string explain() const;

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;        // shared with a loop that may have to be abandoned
  std::unique_ptr<ServoThread> thread_;   // if the loop is ours
  std::unique_ptr<LockedMemory> memory_;  // while a vendor's loop runs
  std::vector<std::string> refused_;
  bool started_ = false;
};

}  // namespace bodkin::haptics
