#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "imaging/image_rgb.h"

namespace bodkin::tracking {

// A grey picture as a camera delivers it, rows from top to bottom.
struct GreyPicture {
  int width = 0, height = 0;         // pixels
  std::vector<std::uint8_t> pixels;  // row by row

  GreyPicture() = default;
  GreyPicture(int columns, int rows)
      : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  std::uint8_t at(int x, int y) const { return pixels[offset(x, y)]; }
  std::uint8_t& at(int x, int y) { return pixels[offset(x, y)]; }
  std::size_t offset(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

// Luma of a colour picture (ITU-R BT.601), and the colour picture of three equal parts.
GreyPicture grey_of(const imaging::ImageRgb& colour);
imaging::ImageRgb colour_of(const GreyPicture& grey);

}  // namespace bodkin::tracking
