#pragma once

#include <optional>
#include <string>

#include "station/second_device.h"

#include "cli/device_options.h"

namespace bodkin::cli {

// The options of a second device.
struct SecondOptions {
  DeviceOptions device;
  std::string role;  // "": plunger
};

// Adds --second, --second-as and --second-settings.
void add_second_options(CLI::App& command, SecondOptions& options);

// None without --second. Throws InputError for options of an absent second device, an unknown role, the device
// `first`, and the mouse, whose window belongs to the needle.
std::optional<station::SecondChoice> choose_second(const SecondOptions& options, const station::DeviceChoice& first);

}  // namespace bodkin::cli
