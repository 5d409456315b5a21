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
  std::string device;    // "DRIVER" or "DRIVER:IDENTITY", as `bodkin devices list` prints it
  std::string plug_in;   // a shared library with somebody else's driver
  std::string settings;  // "key=value ..." for the driver
};

// Adds --plug-in and --settings.
void add_driver_options(CLI::App& command, DeviceOptions& options);

struct ChosenDevice {
  const bodkin_driver* driver = nullptr;
  std::string identity;  // "" = the first
};

// Throws InputError for a name that no driver has, SystemError for a plug-in that cannot be loaded.
ChosenDevice choose_device(const DeviceOptions& options);

// Puts what share/bodkin/devices.csv knows of the model where the device itself tells nothing.
void complete_from_table(DeviceAbilities& abilities);

}  // namespace bodkin
