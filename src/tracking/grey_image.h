#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "imaging/image_rgb.h"

namespace bodkin::tracking {

// A grey image in the format of a camera, rows from top to bottom.
struct GreyImage {
  int width = 0, height = 0;         // pixels
  std::vector<std::uint8_t> pixels;  // row by row

  GreyImage() = default;
  GreyImage(int columns, int rows)
      : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  std::uint8_t at(int x, int y) const { return pixels[offset(x, y)]; }
  std::uint8_t& at(int x, int y) { return pixels[offset(x, y)]; }
  std::size_t offset(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

// Luma of a colour image (ITU-R BT.601), and the colour image of three equal channels.
GreyImage grey_of(const imaging::ImageRgb& colour);
imaging::ImageRgb colour_of(const GreyImage& grey);

}  // namespace bodkin::tracking
