#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// A SpaceMouse or another six-axis puck, through spacenavd's socket: no force, and the puck's deflection is a speed
// that is summed up to a pose. docs/devices.md has the settings.
const bodkin_driver& spacemouse_driver() noexcept;

}  // namespace bodkin::haptics
