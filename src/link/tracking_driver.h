#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::link {

// A tool of a tracker, "openigtlink:HOST:PORT/TOOL", that PLUS, 3D Slicer or another server sends as TRANSFORM or
// TDATA: it is the hand, and feels no force. While poses fail to come the device is lost and the needle stays; it
// connects again on its own. docs/devices.md lists the settings.
const bodkin_driver& tracking_driver() noexcept;

}  // namespace bodkin::link
