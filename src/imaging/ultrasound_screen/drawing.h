#pragma once

#include "imaging/image_rgb.h"
#include "imaging/ultrasound/frame.h"
#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin::imaging {

// The frame with its upper left corner at (x, y), `scale` pixels of the image per pixel of the frame, smoothly.
// Clipped to the image.
void paste_grey(ImageRgb& image, const UltrasoundFrame& frame, OrientationMarkerSide mark, double x, double y,
                double scale);

// Grey levels from white at the top to black.
ImageRgb grey_ramp(int width, int height);

}  // namespace bodkin::imaging
