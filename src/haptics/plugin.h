#pragma once

#include <string>

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// Loads a third-party driver, a shared library that exports bodkin_driver_entry (bodkin_driver.h; docs/devices.md
// says how to write one). The library stays loaded. Throws SystemError: no such file, not a driver, or another
// version of the interface.
const bodkin_driver& load_plugin(const std::string& path);

// Throws SystemError if the driver has another version of the interface or lacks a function. `origin`: for messages.
void check(const bodkin_driver& driver, const std::string& origin);

}  // namespace bodkin::haptics
