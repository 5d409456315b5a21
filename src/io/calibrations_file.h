#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/device_calibration.h"

namespace bodkin::io {

// The file of this user's device calibrations: bodkin/calibrations.xml below $XDG_CONFIG_HOME, or below ~/.config.
// None if neither that variable nor HOME is an absolute path.
std::optional<std::filesystem::path> calibrations_file();

// The calibrations in a file (share/bodkin/calibrations.xsd); none if it does not exist. Throws InputError with file
// and line for an invalid one.
std::vector<haptics::DeviceCalibration> read_calibrations(const std::filesystem::path& file);
// The same from text already in memory; `origin` names it in messages.
std::vector<haptics::DeviceCalibration> parse_calibrations(std::string_view document, const std::string& origin);

// The text that reads back to the same bits.
std::string calibrations_xml(std::span<const haptics::DeviceCalibration> calibrations);

// Replaces the file atomically, creating its folders. Throws SystemError.
void write_calibrations(std::span<const haptics::DeviceCalibration> calibrations, const std::filesystem::path& file);

// The calibration of that device; null when it has none.
const haptics::DeviceCalibration* find_calibration(std::span<const haptics::DeviceCalibration> calibrations,
                                                   std::string_view driver, std::string_view model,
                                                   std::string_view serial);

// Replaces the values of the same device by those in `measured`; values missing there are kept.
void merge_calibration(std::vector<haptics::DeviceCalibration>& calibrations,
                       const haptics::DeviceCalibration& measured);

}  // namespace bodkin::io
