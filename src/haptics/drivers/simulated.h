#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// A simulated hand (SimulatedHand) that moves along a straight line and yields to the wrench that the servo commands.
// It rests above the entry until the force may come, goes in, waits, comes out again and ends the session. One
// exchange is one step of it, so its seconds are those of a servo at its rate_Hz. docs/devices.md has the settings.
const bodkin_driver& simulated_driver() noexcept;

}  // namespace bodkin::haptics
