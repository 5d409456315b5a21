#pragma once

#include <string>

#include "station/device_choice.h"

namespace CLI {
class App;
}

namespace bodkin::cli {

// The driver of a command, and its settings.
struct DeviceOptions {
  std::string device;    // "DRIVER" or "DRIVER:IDENTITY", as `bodkin devices list` prints it; a driver may be a path
  std::string settings;  // "key=value ..." for the driver
};

// Adds --settings.
void add_driver_settings(CLI::App& command, DeviceOptions& options);

// A name with a '/' is the path of a driver; other names are those of the built-in drivers, then of the drivers in
// driver_folder(). Throws InputError for an unknown name, or one used twice in that folder; SystemError for a file
// that is no driver.
station::DeviceChoice choose_device(const DeviceOptions& options);

// Only the driver, without loading it: a built-in driver's name, or the path of a library. Throws InputError as
// choose_device() does.
std::string driver_of(const DeviceOptions& options);

// The mouse, which is a device only in the window of bodkin-app.
bool is_mouse(const DeviceOptions& options);

}  // namespace bodkin::cli
