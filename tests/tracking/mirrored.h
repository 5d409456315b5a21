#pragma once

#include <utility>

#include "imaging/image_rgb.h"

namespace bodkin::tracking {

// Left and right exchanged, as in the mirror view of some cameras.
inline imaging::ImageRgb mirrored(imaging::ImageRgb picture) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width / 2; ++x) std::swap(picture.at(x, y), picture.at(picture.width - 1 - x, y));
  }
  return picture;
}

}  // namespace bodkin::tracking
