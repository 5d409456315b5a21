#pragma once

#include <string>

#include "tracking/camera_calibration.h"

namespace bodkin::tracking {

// Feedback to a person who holds the board before a live camera about rejected images: the reason, once it has lasted
// for half a second, and again every three seconds while it lasts.
class CalibrationTexts {
 public:
  // The next image; `time`: s, of the image. One sentence without its full stop; empty: no feedback now.
  std::string of(PictureUse use, double time);

 private:
  PictureUse use_ = PictureUse::kept;  // of the previous image
  double next_ = 0.0;                  // s, time of the next feedback
};

}  // namespace bodkin::tracking
