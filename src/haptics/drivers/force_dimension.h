#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// Force Dimension's omega, delta, sigma and lambda, and other devices of their SDK, through libdrd.so or libdhd.so.
// Our thread reads and writes; a round ends with the state that the USB controller has just sent. docs/devices.md has
// the settings.
const bodkin_driver& force_dimension_driver() noexcept;

}  // namespace bodkin::haptics
