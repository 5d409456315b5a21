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
  double stall_after = 0.050;      // s without a finished round: the device is stalled
  bool require_real_time = false;  // refuse to run without real-time priority
};

// Runs the servo of a device that leaves the loop to us, on a thread of its own: sleep to the next deadline,
// exchange, tick, over and over. Asks for real-time priority and says what was not granted.
//
// An exchange may block for ever when a vendor's library hangs. No thread can be ended from outside, so a stop() that
// waited long enough leaves it behind: what the two functions need must live as long as they do (hold it in a
// shared_ptr inside them), and the one left behind touches nothing but the exchange that it hangs in; should that
// ever return, the thread ends without another call.
class ServoThread {
 public:
  // Sends the command, gets the state that answers it. What it throws is taken as a fault of the device.
  using Exchange = std::function<void(const Wrench& command, DeviceState& state)>;
  // The round itself, such as ServoTick::step. `dt`: s since the last call; `lateness`: s after the deadline. Must
  // not throw.
  using Tick = std::function<Wrench(const DeviceState& state, double dt, double lateness)>;

  // Throws InputError for settings out of their ranges and empty functions.
  ServoThread(const ServoThreadSettings& settings, Exchange exchange, Tick tick);
  ~ServoThread();  // stop()
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  // Throws SystemError when real-time priority is required but refused, or no thread can be made. Once only.
  void start();
  // No tick any more when it returns; the last exchange has carried a command of zero. False: the exchange has not
  // returned in time and its thread was left behind; the device's own watchdog has to end the force. Never waits
  // longer than the patience. Harmless to repeat.
  bool stop();

  // What the system did not grant, one sentence each; known once start() has returned.
  const std::vector<std::string>& refused() const { return refused_; }
  // For any thread: s since a round was finished last (since start() before the first).
  double silence() const noexcept;
  // Running, but no round was finished for `stall_after`.
  bool is_stalled() const noexcept;
  // Rounds so far, and those that woke up more than a period late.
  std::uint64_t rounds() const noexcept;
  std::uint64_t missed() const noexcept;

 private:
  struct Shared;
  static void run(const std::shared_ptr<Shared>& shared) noexcept;

  ServoThreadSettings settings_;
  std::shared_ptr<Shared> shared_;  // the thread has a share of it too
  std::thread thread_;
  std::vector<std::string> refused_;
  bool stopped_in_time_ = true;
};

}  // namespace bodkin::haptics
