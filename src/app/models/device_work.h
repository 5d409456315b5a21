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

// Opens a device on a thread of its own, watches it or leads through its calibration, and lets it go again. The
// window looks at the state of things once a frame.
class DeviceWork {
 public:
  enum class Task { check, calibrate };
  struct News {
    bool is_busy = false;
    Task task = Task::check;
    haptics::DeviceAbilities abilities;
    bool is_open = false;          // abilities are known
    Pose hand = Pose::Identity();  // mm, operator's frame
    double force = 0.0;            // N that leaves
    std::uint32_t buttons = 0;
    std::string stage;  // of what is being measured
    double fraction = 0.0;
    std::vector<station::CalibrationStep> steps;  // of this device
    std::size_t step = 0;                         // that is being done, as an index of `steps`
    std::vector<std::string> said;                // by the steps, in order
    std::string verdict;                          // of a check or a calibration that is over, one sentence
    bool went_well = false;
    std::string trouble;  // why it came to nothing, one sentence
  };

  DeviceWork() = default;
  // Cancels, and waits for the device to be let go.
  ~DeviceWork();
  DeviceWork(const DeviceWork&) = delete;
  DeviceWork& operator=(const DeviceWork&) = delete;

  // For so many seconds without force, as `bodkin devices check` does. One task at a time: nothing happens while
  // another one runs.
  void check(const station::DeviceChoice& choice, double seconds = 10.0);
  // The steps that the device allows, as `bodkin devices calibrate` does; each waits for go_on(). What was measured
  // is kept in the same file.
  void calibrate(const station::DeviceChoice& choice, const station::CalibrationSettings& settings = {});
  void go_on() { goes_on_.store(true); }
  void cancel() { given_up_.store(true); }
  News news() const;

 private:
  void start(Task task, const station::DeviceChoice& choice, double seconds,
             const station::CalibrationSettings& settings);
  void do_check(const station::DeviceChoice& choice, double seconds);
  void do_calibration(const station::DeviceChoice& choice, const station::CalibrationSettings& settings);
  void show(const haptics::DeviceAbilities& abilities);
  template <typename Change>
  void change(Change&& how);

  mutable std::mutex lock_;  // guards news_
  News news_;
  std::atomic<bool> given_up_{false}, goes_on_{false};
  std::jthread thread_;
};

// What 'bodkin devices calibrate' keeps of the devices of a driver, for people, one line each; empty: nothing.
std::vector<std::string> kept_calibration(const std::string& driver);

}  // namespace bodkin::app
