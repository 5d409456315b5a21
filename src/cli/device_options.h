#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"
#include "haptics/bodkin_driver.h"
#include "haptics/device.h"
#include "haptics/device_calibration.h"

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

  bool is_simulated() const;
  bool is_recorded() const;
  bool is_mouse() const;
};

// A name with a '/' is the file of somebody else's driver; other names are those of the built-in drivers, then of the
// drivers in driver_folder(). Throws InputError for a name that no driver has, or two in that folder; SystemError for
// a file that is no driver.
ChosenDevice choose_device(const DeviceOptions& options);

// The driver alone, without loading it: a built-in driver's name, or the path of a library. Throws InputError
// likewise.
std::string driver_of(const DeviceOptions& options);

// The settings for a driver that is to perform along `path`: a simulated hand aims at it and goes to its end, unless
// the user's words say otherwise.
std::string settings_along(const NeedlePath& path, const ChosenDevice& chosen, const DeviceOptions& options);

// Puts what share/bodkin/devices.csv knows of the model where the device itself tells nothing.
void complete_from_table(DeviceAbilities& abilities);

// What 'devices calibrate' measured of the device; empty where nothing was.
DeviceCalibration calibration_of(const ChosenDevice& chosen, const DeviceAbilities& device);

}  // namespace bodkin
