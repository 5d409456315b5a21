#include "imaging/ultrasound_screen/drawing.h"

#include <algorithm>
#include <cmath>

namespace bodkin {

namespace {

void set_pixel(ImageRgb& image, double x, double y, Rgb ink) {
  if (!(x >= 0.0 && y >= 0.0 && x < image.width && y < image.height)) return;  // NaN is nowhere
  image.at(static_cast<int>(x), static_cast<int>(y)) = ink;
}

// Every `period`-th pixel of a line is left out from `drawn` on.
void draw_steps(ImageRgb& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, Rgb ink, int drawn,
                int period) {
  const double length = (to - from).cwiseAbs().maxCoeff();
  if (!(length < 1e5)) return;
  const int steps = std::max(1, static_cast<int>(std::ceil(length)));
  for (int step = 0; step <= steps; ++step) {
    if (step % period >= drawn) continue;
    const Eigen::Vector2d at = from + (to - from) * step / steps;
    set_pixel(image, at.x(), at.y(), ink);
  }
}

}  // namespace

void paste_grey(ImageRgb& image, const UltrasoundFrame& frame, MarkSide mark, double x, double y, double scale) {
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
      if (mark == MarkSide::left) u = frame.width - 1 - u;
      const int u0 = static_cast<int>(u), u1 = std::min(u0 + 1, frame.width - 1);
      const double upper = pixel(u0, v0) + (u - u0) * (pixel(u1, v0) - pixel(u0, v0));
      const double lower = pixel(u0, v1) + (u - u0) * (pixel(u1, v1) - pixel(u0, v1));
      const auto grey = static_cast<std::uint8_t>(upper + (v - v0) * (lower - upper) + 0.5);
      image.at(column, row) = {grey, grey, grey};
    }
  }
}

void draw_line(ImageRgb& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, Rgb ink) {
  draw_steps(image, from, to, ink, 1, 1);
}

void draw_dotted_line(ImageRgb& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, Rgb ink) {
  draw_steps(image, from, to, ink, 2, 5);
}

void draw_cross(ImageRgb& image, const Eigen::Vector2d& at, double half, Rgb ink) {
  draw_line(image, {at.x() - half, at.y()}, {at.x() + half, at.y()}, ink);
  draw_line(image, {at.x(), at.y() - half}, {at.x(), at.y() + half}, ink);
}

void draw_disc(ImageRgb& image, const Eigen::Vector2d& at, double radius, Rgb ink) {
  for (double y = -radius; y <= radius; y += 1.0) {
    for (double x = -radius; x <= radius; x += 1.0) {
      if (x * x + y * y <= radius * radius) set_pixel(image, at.x() + x, at.y() + y, ink);
    }
  }
}

void draw_pointer(ImageRgb& image, const Eigen::Vector2d& at, double size, Rgb ink) {
  for (double x = 0.0; x <= size; x += 1.0) {
    draw_line(image, {at.x() + x, at.y() - 0.6 * x}, {at.x() + x, at.y() + 0.6 * x}, ink);
  }
}

}  // namespace bodkin
