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

// A driver refused. The message is one sentence that says what to do.
class DeviceError : public SystemError {
 public:
  DeviceError(DeviceFault fault, const std::string& message) : SystemError(message), fault_(fault) {}
  DeviceFault fault() const noexcept { return fault_; }

 private:
  DeviceFault fault_;
};

// What runs on the driver's own thread where the vendor owns the loop.
class DeviceTick {
 public:
  virtual ~DeviceTick() = default;
  // The force on the hand (N, N mm, operator's frame) that answers `state`. dt: s by the clock since the tick before.
  virtual Wrench tick(const DeviceState& state, double dt) noexcept = 0;
};

struct FoundDevice {
  std::string identity;  // for DevicePort
  std::string title;     // for people
};

// A vendor's call that has not returned by then is given up.
constexpr std::chrono::milliseconds usual_patience{20000};

// Throws DeviceError; InputError for settings ("key=value" words) that the driver does not take.
std::vector<FoundDevice> list_devices(const bodkin_driver& driver, const std::string& settings,
                                      std::chrono::milliseconds patience = usual_patience);

// One open device behind any driver. Whatever happens, the device gets a force only between start() and stop(): not
// one that is not finite, not in answer to a state with a fault, and none after the port is gone.
//
// No vendor can hang the program: opening, starting, stopping and closing run on a thread of their own, and one that
// outlasts the patience throws DeviceError{communication_lost}. The abandoned call keeps what it needs alive; if it
// comes back, the device is stopped and closed then. The port is of no use afterwards.
//
// All functions but exchange() are for one thread.
class DevicePort {
 public:
  // Opens a device ("" = the first that is found) without force. `driver` must live for ever, as drivers do. Throws
  // DeviceError; InputError for settings.
  DevicePort(const bodkin_driver& driver, const std::string& identity, const std::string& settings,
             std::chrono::milliseconds patience = usual_patience);
  // Stops and closes, with the same patience.
  ~DevicePort();
  DevicePort(DevicePort&&) noexcept;
  DevicePort& operator=(DevicePort&&) = delete;

  const DeviceAbilities& abilities() const noexcept { return abilities_; }

  // Enables forces. Where the vendor owns the loop, `tick` is called from now until stop() has returned, and is
  // needed; otherwise exchange() works from now on and `tick` is ignored. Throws DeviceError.
  void start(DeviceTick* tick = nullptr);

  // One round where we own the loop: the command out, the state in. By one thread, between start() and stop(); before
  // and after, the fault is not_connected. May block as long as the vendor's read does; allocates nothing and locks
  // nothing of its own.
  void exchange(const Wrench& command, DeviceState& state) noexcept;

  // Zero force, forces disabled. Throws DeviceError when the vendor does not answer. Does nothing when not started.
  void stop();

  // For the calls from now on.
  void set_patience(std::chrono::milliseconds patience) noexcept { patience_ = patience; }

  // Rounds so far, for a watch from any thread: a vendor's loop that has stopped no longer counts.
  std::uint64_t ticks() const noexcept;

  // One sentence about the last fault, with the vendor's own words where the driver passes them on; may be empty.
  std::string explain() const;

 private:
  struct Shared;

  void close() noexcept;
  void must_answer(bool answered, const char* call);

  std::shared_ptr<Shared> shared_;  // with the vendor's thread and with calls that were given up
  std::chrono::milliseconds patience_;
  DeviceAbilities abilities_;
  bool started_ = false;
  bool lost_ = false;  // a call was given up
};

}  // namespace bodkin::haptics
