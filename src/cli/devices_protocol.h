#pragma once

#include <filesystem>

#include "cli/commands.h"
#include "cli/device_options.h"

namespace bodkin::cli {

struct ProtocolOptions {
  std::filesystem::path file;  // to write
  double seconds = 10.0;       // longest duration of a step
  bool without_force = false;
  bool allow_late = false;  // the whole force although the system may delay the servo
};

// Guides a user through the steps that test whether a driver and a device work together, and records the observations
// in a file for the driver's authors. Returns the exit code; a signal ends it without a file. Throws as
// haptics::DevicePort does, and SystemError if the file cannot be written.
int run_device_protocol(const DeviceOptions& device, const ProtocolOptions& options, const CommandContext& context);

}  // namespace bodkin::cli
