#include "tracking/grey_image.h"

#include <algorithm>

namespace bodkin::tracking {

GreyImage grey_of(const imaging::ImageRgb& colour) {
  GreyImage grey(colour.width, colour.height);
  std::transform(colour.pixels.begin(), colour.pixels.end(), grey.pixels.begin(), [](const imaging::Rgb& pixel) {
    return static_cast<std::uint8_t>((77 * pixel.red + 150 * pixel.green + 29 * pixel.blue + 128) >> 8);
  });
  return grey;
}

imaging::ImageRgb colour_of(const GreyImage& grey) {
  imaging::ImageRgb colour(grey.width, grey.height);
  std::transform(grey.pixels.begin(), grey.pixels.end(), colour.pixels.begin(), [](std::uint8_t level) {
    return imaging::Rgb{level, level, level};
  });
  return colour;
}

}  // namespace bodkin::tracking
