#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// A SpaceMouse or another six-axis puck, through spacenavd's socket: no force; the puck's deflection is a velocity
// that is integrated to a pose. docs/devices.md has the settings.
const bodkin_driver& spacemouse_driver() noexcept;

}  // namespace bodkin::haptics
