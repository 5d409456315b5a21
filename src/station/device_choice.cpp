#include "station/device_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "station/hand_session.h"
#include "station/recorded_hand.h"
#include <fmt/format.h>

#include "core/error.h"
#include "haptics/device_profiles.h"
#include "haptics/drivers/simulated.h"
#include "io/calibrations_file.h"
#include "io/device_profiles_file.h"

namespace bodkin::station {

bool DeviceChoice::is_simulated() const {
  return driver == &haptics::simulated_driver();
}

bool DeviceChoice::is_recorded() const {
  return driver == &recorded_driver();
}

bool DeviceChoice::is_mouse() const {
  return std::string_view(driver->name) == "mouse";
}

bool DeviceChoice::is_tracked() const {
  return driver != nullptr && (is_seen() || std::string_view(driver->name) == "openigtlink");
}

bool DeviceChoice::is_seen() const {
  return driver != nullptr && std::string_view(driver->name) == "tracked";
}

std::string settings_about(const Vec3& middle, const anatomy::NeedlePath& path, const DeviceChoice& device) {
  if (!device.is_tracked()) return device.settings;
  std::string words =
      fmt::format("patient_x_mm={:.9g} patient_y_mm={:.9g} patient_z_mm={:.9g} ", middle.x(), middle.y(), middle.z());
  if (device.is_seen()) {
    words += fmt::format("entry_mm={:.9g},{:.9g},{:.9g} target_mm={:.9g},{:.9g},{:.9g} ", path.entry.x(),
                         path.entry.y(), path.entry.z(), path.target.x(), path.target.y(), path.target.z());
  }
  return words + device.settings;
}

std::string settings_along(const anatomy::NeedlePath& path, const DeviceChoice& device) {
  if (device.is_tracked()) return settings_about(workspace_about(path).centre, path, device);
  if (!device.is_simulated()) return device.settings;
  constexpr double degrees = 180.0 / std::numbers::pi;
  const Vec3 line = workspace_about(path).rotation.transpose() * path.direction();  // right, away, up
  return fmt::format("tilt_deg={:.9g} side_deg={:.9g} depth_mm={:.9g} {}", degrees * std::atan2(line.y(), -line.z()),
                     degrees * std::asin(std::clamp(line.x(), -1.0, 1.0)), path.length(), device.settings);
}

void complete_from_table(haptics::DeviceAbilities& abilities) {
  const auto profiles = io::default_device_profiles();
  if (const haptics::DeviceProfile* profile = haptics::find_profile(profiles, abilities.name))
    haptics::complete(abilities, *profile);
}

haptics::DeviceCalibration calibration_of(const DeviceChoice& choice, const haptics::DeviceAbilities& device) {
  const auto file = io::calibrations_file();
  if (!file) return {};
  const std::vector<haptics::DeviceCalibration> all = io::read_calibrations(*file);
  const haptics::DeviceCalibration* known =
      io::find_calibration(all, choice.driver->name, device.name, device.serial);
  return known == nullptr ? haptics::DeviceCalibration() : *known;
}

void require_same_rate(const DeviceChoice& choice, const haptics::DeviceAbilities& device, double rate) {
  constexpr double tolerance = 0.01;  // of the rate
  if (std::abs(device.rate - rate) <= tolerance * rate) return;
  if (choice.is_simulated()) {
    throw InputError(
        fmt::format("the simulated hand moves at {:g} Hz and the case at {:g} Hz; add --settings rate_Hz={:g}",
                    device.rate, rate, rate));
  }
  if (choice.is_recorded()) {
    throw InputError(
        fmt::format("{} was recorded at {:g} Hz and the case runs at {:g} Hz, expected the same rate; set "
                    "rate_Hz of the case's haptics to the recording's",
                    choice.identity, device.rate, rate));
  }
  if (!device.owns_loop) return;
  throw InputError(fmt::format(
      "the device runs at {:g} Hz and the case at {:g} Hz; set rate_Hz of the case's haptics to the device's",
      device.rate, rate));
}

}  // namespace bodkin::station
