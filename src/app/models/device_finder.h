#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "station/device_choice.h"
#include "station/driver_inquiry.h"

namespace bodkin::app {

// A row of the list of devices: the mouse, a detected device, or a driver without a device.
struct DeviceRow {
  enum class Lamp { good, off, trouble };  // available; not connected; something is missing
  std::string driver;                      // name of the driver, "force_dimension"; empty: the mouse of the window
  std::string identity;                    // of the device, empty where there is none
  std::string title;                       // for people
  std::string state;                       // "found", "not connected", "library missing"
  std::string sentence;                    // what is missing and how to correct it; empty: nothing
  Lamp lamp = Lamp::off;

  bool is_mouse() const { return driver.empty(); }
  bool can_open() const { return lamp == Lamp::good; }
};

// The rows of a driver's answer.
std::vector<DeviceRow> rows_of(const station::DriverAnswer& answer);

// Asks all drivers one after the other, each in a separate process (as `bodkin devices list` does), on a thread.
class DeviceFinder {
 public:
  DeviceFinder() = default;
  // Waits for the driver in progress, 8 s at most.
  ~DeviceFinder();
  DeviceFinder(const DeviceFinder&) = delete;
  DeviceFinder& operator=(const DeviceFinder&) = delete;

  // Discards the results and asks again. No effect while it is asking.
  void start();
  void cancel() { cancelled_.store(true); }
  bool is_busy() const;
  std::string asking() const;  // the driver in progress; empty: none
  // The mouse and the devices detected so far. `version` changes with every row.
  std::vector<DeviceRow> rows() const;
  std::size_t version() const;

 private:
  void work(const std::filesystem::path& program);

  mutable std::mutex lock_;  // guards the four below
  std::vector<DeviceRow> rows_;
  std::string asking_;
  std::size_t version_ = 0;
  bool busy_ = false;
  std::atomic<bool> cancelled_{false};
  std::jthread thread_;
};

// How to open the device of a row. Throws InputError and SystemError for a driver that cannot be loaded.
station::DeviceChoice choice_of(const DeviceRow& row);

}  // namespace bodkin::app
