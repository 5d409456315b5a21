#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "haptics/bodkin_driver.h"
#include "haptics/device.h"

namespace bodkin::haptics {

// A driver reported an error. The message is one sentence that says what to do.
class DeviceError : public SystemError {
 public:
  DeviceError(DeviceFault fault, const std::string& message) : SystemError(message), fault_(fault) {}
  DeviceFault fault() const noexcept { return fault_; }

 private:
  DeviceFault fault_;
};

// The tick that runs on the driver's own thread when the vendor owns the loop.
class DeviceTick {
 public:
  virtual ~DeviceTick() = default;
  // The force on the hand (N, N mm, operator's frame) in response to `state`. dt: measured s since the previous tick.
  virtual Wrench tick(const DeviceState& state, double dt) noexcept = 0;
};

struct FoundDevice {
  std::string identity;  // for DevicePort
  std::string title;     // for people
};

// A vendor's call that has not returned after this time is abandoned.
constexpr std::chrono::milliseconds usual_patience{20000};

// Throws DeviceError; InputError for settings ("key=value" words) that the driver does not accept.
std::vector<FoundDevice> list_devices(const bodkin_driver& driver, const std::string& settings,
                                      std::chrono::milliseconds patience = usual_patience);

// One open device behind any driver. The device gets a force only between start() and stop(): never one that is not
// finite, never in response to a state with a fault, and never after the port is destroyed.
//
// No vendor can hang the program: opening, starting, stopping and closing run on a separate thread, and a call that
// outlasts the patience throws DeviceError{communication_lost}. The abandoned call keeps everything it needs alive;
// if it returns, the device is then stopped and closed. The port can no longer be used.
//
// All functions but exchange() are for one thread.
class DevicePort {
 public:
  // Opens a device ("" = the first one found) without force. `driver` must never be destroyed. Throws DeviceError;
  // InputError for settings.
  DevicePort(const bodkin_driver& driver, const std::string& identity, const std::string& settings,
             std::chrono::milliseconds patience = usual_patience);
  // Stops and closes, with the same patience.
  ~DevicePort();
  DevicePort(DevicePort&&) noexcept;
  DevicePort& operator=(DevicePort&&) = delete;

  const DeviceAbilities& abilities() const noexcept { return abilities_; }

  // Enables forces. If the vendor owns the loop, `tick` is required and is called until stop() has returned;
  // otherwise exchange() works from now on and `tick` is ignored. Throws DeviceError.
  void start(DeviceTick* tick = nullptr);

  // One round of our own loop: the command out, the state in. By one thread, between start() and stop(); before and
  // after, the fault is not_connected. May block as long as the vendor's read does; allocates and locks nothing
  // itself.
  void exchange(const Wrench& command, DeviceState& state) noexcept;

  // Zero force, forces disabled. Throws DeviceError when the vendor does not respond. No effect when not started.
  void stop();

  // Applies to later calls.
  void set_patience(std::chrono::milliseconds patience) noexcept { patience_ = patience; }

  // Rounds so far, for a watchdog on any thread: a vendor's loop that has stopped no longer counts.
  std::uint64_t ticks() const noexcept;

  // One sentence about the last fault, with the vendor's own words where the driver passes them on; may be empty.
  std::string explain() const;

 private:
  struct Shared;

  void close() noexcept;
  void must_answer(bool answered, const char* call);

  std::shared_ptr<Shared> shared_;  // shared with the vendor's thread and with abandoned calls
  std::chrono::milliseconds patience_;
  DeviceAbilities abilities_;
  bool started_ = false;
  bool lost_ = false;  // a call was abandoned
};

}  // namespace bodkin::haptics
