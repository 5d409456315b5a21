#pragma once

#include <filesystem>

#include "cli/commands.h"
#include "cli/device_options.h"

namespace bodkin::cli {

struct ProtocolOptions {
  std::filesystem::path file;  // to write
  double seconds = 10.0;       // that a step lasts at most
  bool without_force = false;
  bool allow_late = false;  // the whole force although the system may hold up the servo
};

// Leads a person through the steps that show whether a driver and a device understand each other, and writes what was
// seen to a file that can be sent to the people who write the driver. Returns the exit code; a signal ends it without
// a file. Throws as haptics::DevicePort does, and SystemError when the file cannot be written.
int run_device_protocol(const DeviceOptions& device, const ProtocolOptions& options, const CommandContext& context);

}  // namespace bodkin::cli
