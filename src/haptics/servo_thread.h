#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "haptics/device.h"

namespace bodkin::haptics {

struct ServoThreadSettings {
  double period = 0.001;           // s; 0.00025 to 0.005
  double patience = 0.5;           // s that stop() waits for an exchange to return
  double stall_after = 0.050;      // s without a complete round after which the device is stalled
  bool require_real_time = false;  // refuse to run without real-time priority
};

// Runs the servo of a device without a loop of its own, on a separate thread: sleep to the next deadline, exchange,
// tick, repeatedly. Requests real-time priority and reports refusals.
//
// An exchange may block forever when a vendor's library hangs. No thread can be ended from outside, so after waiting
// long enough stop() abandons it: everything that the two functions need must live as long as they do (hold it in a
// shared_ptr inside them). The abandoned thread touches nothing but the exchange that it hangs in; if that ever
// returns, the thread ends without another call.
class ServoThread {
 public:
  // Sends the command and receives the state that responds to it. An exception counts as a fault of the device.
  using Exchange = std::function<void(const Wrench& command, DeviceState& state)>;
  // The work of a round, such as ServoTick::step. `dt`: s since the last call; `lateness`: s after the deadline. Must
  // not throw.
  using Tick = std::function<Wrench(const DeviceState& state, double dt, double lateness)>;

  // Throws InputError for settings out of their ranges and empty functions.
  ServoThread(const ServoThreadSettings& settings, Exchange exchange, Tick tick);
  ~ServoThread();  // stop()
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  // Throws SystemError when real-time priority is required but refused, or no thread can be created. Once only.
  void start();
  // When it returns, no tick will follow, and the last exchange has sent a command of zero. False: the exchange has
  // not returned in time and its thread was abandoned; the device's own watchdog has to end the force. Never waits
  // longer than the patience. May be repeated.
  bool stop();

  // Requests that the system refused, one sentence each; known once start() has returned.
  const std::vector<std::string>& refused() const { return refused_; }
  // For any thread: s since the last complete round (since start() before the first).
  double silence() const noexcept;
  // Running, but without a complete round for `stall_after`.
  bool is_stalled() const noexcept;
  // Rounds so far, and those that woke up more than a period late.
  std::uint64_t rounds() const noexcept;
  std::uint64_t missed() const noexcept;

 private:
  struct Shared;
  static void run(const std::shared_ptr<Shared>& shared) noexcept;

  ServoThreadSettings settings_;
  std::shared_ptr<Shared> shared_;  // shared with the thread
  std::thread thread_;
  std::vector<std::string> refused_;
  bool stopped_in_time_ = true;
};

}  // namespace bodkin::haptics
