#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "imaging/ultrasound/frame.h"
#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin::imaging {

// An ultrasound image as displayed, simulated or real.
struct GreyImage {
  int width = 0, height = 0;         // pixels
  double pixel = 0.0;                // mm, square
  double top = 0.0;                  // mm, depth of the first row's centres below the middle of the face
  std::vector<std::uint8_t> pixels;  // height x width, row by row

  // Pixels of a position: mm to the right of the image's middle and below the face.
  double column(double across) const { return across / pixel + 0.5 * (width - 1); }
  double row(double depth) const { return (depth - top) / pixel; }
};

// A frame as an image with the orientation marker at `mark`.
GreyImage grey_of(const UltrasoundFrame& frame, OrientationMarkerSide mark);

// A rectangle in an image: its middle, mm to the right of the image's middle and below the face, and its size, mm.
struct GreyWindow {
  double across = 0.0, depth = 0.0;
  double width = 0.0, height = 0.0;
};

// A window in pixels.
struct PixelWindow {
  int left = 0, top = 0, width = 0, height = 0;
};

// The pixels whose centres lie in the window; empty if it extends beyond the image (by more than a pixel) or has
// fewer than 8 x 8 of them.
std::optional<PixelWindow> pixels_in(const GreyImage& picture, const GreyWindow& window);

// Statistics of the grey levels in a window.
struct GreyStatistics {
  std::array<int, 5> percentiles{};  // 5, 25, 50, 75, 95 %: the least grey level that this many pixels do not exceed
  // Half-widths of the grey levels' autocorrelation, across (along rows) and along the lines (along columns), mm: the
  // distance at which the grey levels of pixels, less the window's mean, have a correlation of a half. Empty if all
  // are equal, or if the correlation is higher throughout half the window.
  std::optional<double> across, along;
};

GreyStatistics grey_statistics(const GreyImage& picture, const PixelWindow& window);

}  // namespace bodkin::imaging
