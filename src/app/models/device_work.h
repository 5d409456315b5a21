#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "station/calibration_steps.h"
#include "station/device_choice.h"

#include "haptics/device.h"
#include "haptics/device_calibration.h"

namespace bodkin::app {

// Opens a device on a separate thread, monitors it or guides through its calibration, and closes it. The window reads
// the state once a frame.
class DeviceWork {
 public:
  enum class Task { check, calibrate };
  struct Status {
    bool is_busy = false;
    Task task = Task::check;
    haptics::DeviceAbilities abilities;
    bool is_open = false;          // abilities are known
    Pose hand = Pose::Identity();  // mm, operator's frame
    double force = 0.0;            // N on the device
    std::uint32_t buttons = 0;
    std::string stage;  // of the measurement
    double fraction = 0.0;
    std::vector<station::CalibrationStep> steps;  // of this device
    std::size_t step = 0;                         // the current one, as an index of `steps`
    std::vector<std::string> messages;            // messages of the steps, in order
    std::string verdict;                          // of a finished check or calibration, one sentence
    bool went_well = false;
    std::string trouble;  // why it failed, one sentence
  };

  DeviceWork() = default;
  // Cancels, and waits until the device is closed.
  ~DeviceWork();
  DeviceWork(const DeviceWork&) = delete;
  DeviceWork& operator=(const DeviceWork&) = delete;

  // Monitors without force for `seconds`, as `bodkin devices check` does. One task at a time: no effect during
  // another task.
  void check(const station::DeviceChoice& choice, double seconds = 10.0);
  // The steps that the device allows, as `bodkin devices calibrate` does; each waits for go_on(). The results are
  // stored in the same file.
  void calibrate(const station::DeviceChoice& choice, const station::CalibrationSettings& settings = {});
  void go_on() { confirmed_.store(true); }
  void cancel() { cancelled_.store(true); }
  Status status() const;

 private:
  void start(Task task, const station::DeviceChoice& choice, double seconds,
             const station::CalibrationSettings& settings);
  void do_check(const station::DeviceChoice& choice, double seconds);
  void do_calibration(const station::DeviceChoice& choice, const station::CalibrationSettings& settings);
  void show(const haptics::DeviceAbilities& abilities);
  template <typename Change>
  void change(Change&& how);

  mutable std::mutex lock_;  // guards status_
  Status status_;
  std::atomic<bool> cancelled_{false}, confirmed_{false};
  std::jthread thread_;
};

// The stored calibration ('bodkin devices calibrate') of a driver's devices, for display, one line each; empty: none.
std::vector<std::string> kept_calibration(const std::string& driver);

}  // namespace bodkin::app
