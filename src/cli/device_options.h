#pragma once

#include <string>

#include "haptics/bodkin_driver.h"
#include "haptics/device.h"

namespace CLI {
class App;
}

namespace bodkin {

// Which driver a command is to use, and how.
struct DeviceOptions {
  std::string device;    // "DRIVER" or "DRIVER:IDENTITY", as `bodkin devices list` prints it; a driver may be a path
  std::string settings;  // "key=value ..." for the driver
};

// Adds --settings.
void add_driver_settings(CLI::App& command, DeviceOptions& options);

struct ChosenDevice {
  const bodkin_driver* driver = nullptr;
  std::string identity;  // "" = the first
};

// A name with a '/' is the file of somebody else's driver. Throws InputError for a name that no driver has,
// SystemError for a file that is no driver.
ChosenDevice choose_device(const DeviceOptions& options);

// Puts what share/bodkin/devices.csv knows of the model where the device itself tells nothing.
void complete_from_table(DeviceAbilities& abilities);

}  // namespace bodkin
