#pragma once

#include <string>

#include "tracking/camera_calibration.h"

namespace bodkin::tracking {

// What a person who holds the board before a live camera is told of pictures that are not kept: the reason, once it
// has lasted for half a second, and again every three seconds while it lasts.
class CalibrationWords {
 public:
  // The next picture; `time`: s, of the picture. One sentence without its end; empty: nothing is to be said now.
  std::string of(PictureUse use, double time);

 private:
  PictureUse use_ = PictureUse::kept;  // of the picture before
  double next_ = 0.0;                  // s, when it is to be said
};

}  // namespace bodkin::tracking
