#include "imaging/ultrasound_screen/drawing.h"

#include <algorithm>
#include <cmath>

namespace bodkin::imaging {

void paste_grey(ImageRgb& image, const UltrasoundFrame& frame, OrientationMarkerSide mark, double x, double y,
                double scale) {
  const int left = std::max(0, static_cast<int>(std::ceil(x))), top = std::max(0, static_cast<int>(std::ceil(y)));
  const int right = std::min(image.width, static_cast<int>(std::floor(x + scale * frame.width)));
  const int bottom = std::min(image.height, static_cast<int>(std::floor(y + scale * frame.height)));
  const auto pixel = [&](int column, int row) {
    return static_cast<double>(frame.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.width) +
                                            static_cast<std::size_t>(column)]);
  };
  for (int row = top; row < bottom; ++row) {
    const double v = std::clamp((row + 0.5 - y) / scale - 0.5, 0.0, frame.height - 1.0);
    const int v0 = static_cast<int>(v), v1 = std::min(v0 + 1, frame.height - 1);
    for (int column = left; column < right; ++column) {
      double u = std::clamp((column + 0.5 - x) / scale - 0.5, 0.0, frame.width - 1.0);
      if (mark == OrientationMarkerSide::left) u = frame.width - 1 - u;
      const int u0 = static_cast<int>(u), u1 = std::min(u0 + 1, frame.width - 1);
      const double upper = pixel(u0, v0) + (u - u0) * (pixel(u1, v0) - pixel(u0, v0));
      const double lower = pixel(u0, v1) + (u - u0) * (pixel(u1, v1) - pixel(u0, v1));
      const auto grey = static_cast<std::uint8_t>(upper + (v - v0) * (lower - upper) + 0.5);
      image.at(column, row) = {grey, grey, grey};
    }
  }
}

ImageRgb grey_ramp(int width, int height) {
  ImageRgb ramp(width, height);
  for (int row = 0; row < height; ++row) {
    const auto grey = static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - row / (height - 1.0))));
    for (int column = 0; column < width; ++column) ramp.at(column, row) = {grey, grey, grey};
  }
  return ramp;
}

}  // namespace bodkin::imaging
