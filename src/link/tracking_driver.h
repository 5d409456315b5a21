#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::link {

// A tool of a tracker as the hand, "openigtlink:HOST:PORT/TOOL", sent by PLUS, 3D Slicer or another server as
// TRANSFORM or TDATA; it feels no force. While no poses arrive the device is lost and the needle stays; it reconnects
// on its own. docs/devices.md lists the settings.
const bodkin_driver& tracking_driver() noexcept;

}  // namespace bodkin::link
