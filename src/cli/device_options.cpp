#include "cli/device_options.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "desktop/mouse_driver.h"
#include "station/hand_session.h"
#include "station/recorded_hand.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/all_drivers.h"
#include "cli/arguments.h"
#include "cli/driver_inquiry.h"
#include "core/error.h"
#include "haptics/device_profiles.h"
#include "haptics/driver_folder.h"
#include "haptics/drivers/simulated.h"
#include "io/calibrations_file.h"
#include "io/device_profiles_file.h"

namespace bodkin {

void add_driver_settings(CLI::App& command, DeviceOptions& options) {
  add_text(command, "--settings", options.settings,
           "Settings of the driver, \"KEY=VALUE ...\", such as library=/opt/sdk/libdrd.so");
}

namespace {

// The library in the folder of drivers whose driver has that name.
std::string file_of_driver(const std::string& name) {
  std::vector<std::string> names, files;
  for (const bodkin_driver* driver : all_drivers()) names.emplace_back(driver->name);
  for (const std::string& file : driver_files()) {
    const DriverAnswer answer = ask_driver(file, "", Inquiry::name);
    if (answer.name == name) files.push_back(file);
    if (!answer.name.empty()) names.push_back(answer.name);
  }
  if (files.size() == 1) return files.front();
  if (files.empty()) {
    throw InputError(fmt::format("there is no driver '{}'; expected {}, or the path of a driver with a '/' in it",
                                 name, fmt::join(names, ", ")));
  }
  throw InputError(fmt::format("{} drivers are called '{}'; say which by its path: {}", files.size(), name,
                               fmt::join(files, ", ")));
}

}  // namespace

std::string driver_of(const DeviceOptions& options) {
  const std::string name = options.device.substr(0, options.device.find(':'));
  return name.find('/') != std::string::npos || find_own_driver(name) != nullptr ? name : file_of_driver(name);
}

bool ChosenDevice::is_simulated() const {
  return driver == &simulated_driver();
}

bool ChosenDevice::is_recorded() const {
  return driver == &recorded_driver();
}

bool ChosenDevice::is_mouse() const {
  return driver == &mouse_driver();
}

ChosenDevice choose_device(const DeviceOptions& options) {
  const std::size_t colon = options.device.find(':');
  const std::string identity = colon == std::string::npos ? "" : options.device.substr(colon + 1);
  return {&load_driver(driver_of(options)), identity};
}

std::string settings_along(const NeedlePath& path, const ChosenDevice& chosen, const DeviceOptions& options) {
  if (!chosen.is_simulated()) return options.settings;
  constexpr double degrees = 180.0 / std::numbers::pi;
  const Vec3 way = workspace_about(path).rotation.transpose() * path.direction();  // right, away, up
  return fmt::format("tilt_deg={:.9g} side_deg={:.9g} depth_mm={:.9g} {}", degrees * std::atan2(way.y(), -way.z()),
                     degrees * std::asin(std::clamp(way.x(), -1.0, 1.0)), path.length(), options.settings);
}

void complete_from_table(DeviceAbilities& abilities) {
  const auto profiles = default_device_profiles();
  if (const DeviceProfile* profile = find_profile(profiles, abilities.name)) complete(abilities, *profile);
}

DeviceCalibration calibration_of(const ChosenDevice& chosen, const DeviceAbilities& device) {
  const auto file = calibrations_file();
  if (!file) return {};
  const std::vector<DeviceCalibration> all = read_calibrations(*file);
  const DeviceCalibration* known = find_calibration(all, chosen.driver->name, device.name, device.serial);
  return known == nullptr ? DeviceCalibration() : *known;
}

}  // namespace bodkin
