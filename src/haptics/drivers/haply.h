#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::haptics {

// Haply's Inverse3, Inverse3x and Minverse with a VerseGrip, through the vendor's Inverse service, which speaks JSON
// on a WebSocket and answers every message with one state. Our thread writes and reads; a round ends with the answer.
// docs/devices.md has the settings.
const bodkin_driver& haply_driver() noexcept;

}  // namespace bodkin::haptics
