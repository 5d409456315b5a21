#include "app/models/device_finder.h"

#include <exception>
#include <utility>

#include "station/recorded_hand.h"
#include <fmt/format.h>

#include "core/error.h"
#include "haptics/driver_folder.h"
#include "haptics/drivers/drivers.h"
#include "haptics/plugin.h"
#include "io/worker_program.h"

namespace bodkin::app {

std::vector<DeviceRow> rows_of(const station::DriverAnswer& answer) {
  const std::string name = answer.name.empty() ? answer.driver : answer.name;
  std::vector<DeviceRow> rows;
  for (const haptics::FoundDevice& device : answer.devices) {
    rows.push_back({answer.driver, device.identity, device.title.empty() ? name : device.title, "found", "",
                    DeviceRow::Lamp::good});
  }
  if (!rows.empty()) return rows;
  DeviceRow row{answer.driver,   "", answer.summary.empty() ? name : answer.summary,
                "not connected", "", DeviceRow::Lamp::off};
  if (answer.fault != haptics::DeviceFault::none) {
    const bool absent = answer.fault == haptics::DeviceFault::not_connected;
    row.lamp = absent ? DeviceRow::Lamp::off : DeviceRow::Lamp::trouble;
    row.state = haptics::text_of(answer.fault);
    row.sentence = answer.sentence;
  } else {
    row.sentence = fmt::format("No device answers to {}: switch it on, plug it in, and look again.", name);
  }
  return {row};
}

DeviceFinder::~DeviceFinder() {
  cancel();
}

void DeviceFinder::start() {
  {
    const std::lock_guard guard(lock_);
    if (std::exchange(busy_, true)) return;
    rows_ = {{"", "", "Mouse of this window", "found", "", DeviceRow::Lamp::good}};
    ++version_;
  }
  cancelled_.store(false);
  thread_ = std::jthread([this] {
    std::string trouble;
    try {
      work(io::find_worker({"bodkin", "BODKIN_PROGRAM", "BODKIN_CLI"}));
    } catch (const std::exception& error) {
      trouble = error.what();
    }
    const std::lock_guard guard(lock_);
    if (!trouble.empty())
      rows_.push_back({"bodkin", "", "Other devices", "not found", trouble, DeviceRow::Lamp::trouble});
    asking_.clear();
    busy_ = false;
    ++version_;
  });
}

void DeviceFinder::work(const std::filesystem::path& program) {
  std::vector<std::string> drivers;
  for (const bodkin_driver* driver : haptics::built_in_drivers()) drivers.emplace_back(driver->name);
  for (const std::string& file : haptics::driver_files()) drivers.push_back(file);
  for (const std::string& driver : drivers) {
    if (cancelled_.load()) return;
    {
      const std::lock_guard guard(lock_);
      asking_ = driver;
      ++version_;
    }
    station::DriverAnswer answer;
    try {
      answer = station::ask_driver(driver, "", station::Inquiry::devices, program);
    } catch (const InputError& error) {
      answer.driver = driver;
      answer.fault = haptics::DeviceFault::vendor_error;
      answer.sentence = error.what();
    }
    const std::vector<DeviceRow> found = rows_of(answer);
    const std::lock_guard guard(lock_);
    rows_.insert(rows_.end(), found.begin(), found.end());
    ++version_;
  }
}

bool DeviceFinder::is_busy() const {
  const std::lock_guard guard(lock_);
  return busy_;
}

std::string DeviceFinder::asking() const {
  const std::lock_guard guard(lock_);
  return asking_;
}

std::vector<DeviceRow> DeviceFinder::rows() const {
  const std::lock_guard guard(lock_);
  return rows_;
}

std::size_t DeviceFinder::version() const {
  const std::lock_guard guard(lock_);
  return version_;
}

station::DeviceChoice choice_of(const DeviceRow& row) {
  station::DeviceChoice choice;
  choice.identity = row.identity;
  if (row.driver.find('/') != std::string::npos) {
    choice.driver = &haptics::load_plugin(row.driver);
  } else if (row.driver == station::recorded_driver().name) {
    choice.driver = &station::recorded_driver();
  } else {
    choice.driver = haptics::find_driver(row.driver);
  }
  if (choice.driver == nullptr)
    throw InputError(fmt::format("there is no driver '{}'; choose another device on the page Devices", row.driver));
  return choice;
}

}  // namespace bodkin::app
