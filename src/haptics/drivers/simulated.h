#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// A simulated hand (SimulatedHand) that moves along a straight line and yields to the servo's wrench. It rests above
// the entry until forces are enabled, inserts, waits, withdraws and ends the session. One exchange is one step of it,
// so its seconds are those of a servo at its rate_Hz. docs/devices.md has the settings.
const bodkin_driver& simulated_driver() noexcept;

}  // namespace bodkin::haptics
