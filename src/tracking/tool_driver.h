#pragma once

#include "haptics/bodkin_driver.h"

namespace bodkin::tracking {

// A real tool with a marker body over a mannequin as the hand, "tracked:SOURCE": a camera, a video or a folder of
// images. It renders no force. While it is not seen well it rests at the last place, and reports
// BODKIN_BUTTON_UNSEEN; its explain() gives the reason, and while the tool is seen remarks about the images
// (PictureSource::notes()). Two tools of one source share its images, and so does a window that shows them
// (announce()). docs/devices.md lists the settings.
const bodkin_driver& tool_driver() noexcept;

}  // namespace bodkin::tracking
