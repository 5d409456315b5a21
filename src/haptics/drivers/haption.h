#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// Haption's Virtuose devices, through libVirtuoseAPI.so. Its periodic function calls the tick. docs/devices.md has
// the settings.
const bodkin_driver& haption_driver() noexcept;

}  // namespace bodkin::haptics
