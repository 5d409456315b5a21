#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "haptics/bodkin_driver.h"

namespace bodkin::cli {

// The drivers of this program: those of devices (haptics/drivers/drivers.h), of a recorded hand, of a tracker, and of
// a tool in front of a camera. The mouse is a device of the window (app/hand/mouse_driver.h).
std::vector<const bodkin_driver*> all_drivers();

// The driver of that name; null if there is none.
const bodkin_driver* find_own_driver(std::string_view name);

// The driver of that name, or a third-party one by the path of its library, which contains a '/'. Throws InputError
// for an unknown name and SystemError for a library that is no driver.
const bodkin_driver& load_driver(const std::string& name);

}  // namespace bodkin::cli
