#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// Touch, Touch X and the PHANTOM devices of 3D Systems, through OpenHaptics' libHD.so. Its scheduler's thread calls
// the tick. docs/devices.md has the settings.
const bodkin_driver& openhaptics_driver() noexcept;

}  // namespace bodkin::haptics
