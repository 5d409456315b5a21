#pragma once

#include "imaging/image_rgb.h"
#include "imaging/ultrasound/frame.h"
#include "imaging/ultrasound_screen/scan_field.h"

namespace bodkin {

// The little that a machine's screen needs to draw into pixels. What lies outside the image is left out.

// The frame with its upper left corner at (x, y), `scale` pixels of the image per pixel of the frame, smoothly.
void paste_grey(ImageRgb& image, const UltrasoundFrame& frame, MarkSide mark, double x, double y, double scale);
// One pixel wide.
void draw_line(ImageRgb& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, Rgb ink);
void draw_dotted_line(ImageRgb& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, Rgb ink);
// An upright cross that reaches `half` pixels to each side.
void draw_cross(ImageRgb& image, const Eigen::Vector2d& at, double half, Rgb ink);
void draw_disc(ImageRgb& image, const Eigen::Vector2d& at, double radius, Rgb ink);
// A triangle whose tip at `at` points to the left.
void draw_pointer(ImageRgb& image, const Eigen::Vector2d& at, double size, Rgb ink);

}  // namespace bodkin
