#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "imaging/ultrasound/frame.h"
#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin::imaging {

// An ultrasound picture as it is looked at, a simulated or a real one.
struct GreyPicture {
  int width = 0, height = 0;         // pixels
  double pixel = 0.0;                // mm, square
  double top = 0.0;                  // mm, depth of the first row's centres below the middle of the face
  std::vector<std::uint8_t> pixels;  // height x width, row by row

  // Pixels of a place: mm to the right of the picture's middle and below the face.
  double column(double across) const { return across / pixel + 0.5 * (width - 1); }
  double row(double depth) const { return (depth - top) / pixel; }
};

// A frame as a picture with the marked side at `mark`.
GreyPicture grey_of(const UltrasoundFrame& frame, MarkSide mark);

// A rectangle in a picture: its middle, mm to the right of the picture's middle and below the face, and its size, mm.
struct GreyWindow {
  double across = 0.0, depth = 0.0;
  double width = 0.0, height = 0.0;
};

// The same in pixels.
struct PixelWindow {
  int left = 0, top = 0, width = 0, height = 0;
};

// The pixels whose centres lie in the window; nothing when it reaches beyond the picture (by more than a pixel) or
// has fewer than 8 x 8 of them.
std::optional<PixelWindow> pixels_in(const GreyPicture& picture, const GreyWindow& window);

// What the greys of a window are like.
struct GreyStatistics {
  std::array<int, 5> percentiles{};  // 5, 25, 50, 75, 95 %: the least grey that so many pixels do not exceed
  // Half-widths of the greys' autocorrelation, across (along rows) and along the lines (along columns), mm: how far
  // apart pixels are whose greys, with the window's mean taken from them, correlate by a half. Nothing when all are
  // equal, or when they correlate by more throughout half the window.
  std::optional<double> across, along;
};

GreyStatistics grey_statistics(const GreyPicture& picture, const PixelWindow& window);

}  // namespace bodkin::imaging
