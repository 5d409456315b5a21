#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::tracking {

// A real tool with a marker body over a mannequin is the hand, "tracked:SOURCE": a camera, a video or a folder of
// pictures. It renders no force. Where it is not seen well it rests at the last place, and says so by
// BODKIN_BUTTON_UNSEEN; its explain() says why, and while the tool is seen what is to be known of the pictures
// (PictureSource::notes()). Two tools of one source share its pictures, and so does a window that shows them
// (announce()). docs/devices.md lists the settings.
const bodkin_driver& tool_driver() noexcept;

}  // namespace bodkin::tracking
