#pragma once

#include <memory>

#include "core/latest_value.h"
#include "haptics/bodkin_driver.h"
#include "haptics/pointer_hand.h"

namespace bodkin::desktop {

// Where a window leaves what it knows of the pointer (one writer) for the loop of the device (one reader).
using PointerFeed = LatestValue<haptics::PointerState>;

// A device that is opened from now on follows this pointer, for as long as the feed lives; there is one mouse.
void connect_mouse(const std::shared_ptr<PointerFeed>& feed);

// Mouse and keyboard as a device without force. It needs a MouseWindow, which the command that opens it shows. The
// settings stand in docs/devices.md.
const bodkin_driver& mouse_driver() noexcept;

}  // namespace bodkin::desktop
