#include "imaging/canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "imaging/markup.h"
#include "imaging/png_file.h"

namespace bodkin::imaging {

Path Path::segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return polyline({from, to});
}

Path Path::polyline(const std::vector<Eigen::Vector2d>& points) {
  Path path;
  for (const Eigen::Vector2d& point : points)
    path.parts_.push_back({path.parts_.empty() ? Kind::move : Kind::line, point});
  return path;
}

Path Path::polygon(const std::vector<Eigen::Vector2d>& points) {
  Path path = polyline(points);
  path.close();
  return path;
}

Path Path::rectangle(double x, double y, double width, double height) {
  return polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

Path Path::circle(const Eigen::Vector2d& centre, double radius) {
  Path path;
  path.parts_.push_back({Kind::circle, centre, radius});
  return path;
}

Path Path::cross(const Eigen::Vector2d& centre, double half) {
  Path path = segment(centre - half * Eigen::Vector2d::UnitX(), centre + half * Eigen::Vector2d::UnitX());
  path.add(segment(centre - half * Eigen::Vector2d::UnitY(), centre + half * Eigen::Vector2d::UnitY()));
  return path;
}

namespace {

bool is_drawable(const Path& path) {
  return !path.parts().empty() && std::all_of(path.parts().begin(), path.parts().end(), [](const Path::Part& part) {
    return part.at.allFinite() && std::isfinite(part.radius);
  });
}

}  // namespace

void Canvas::set_size(double width, double height) {
  width_ = width;
  height_ = height;
}

void Canvas::fill(Path path, const Ink& ink) {
  if (is_drawable(path)) shapes_.emplace_back(Filled{std::move(path), ink});
}

void Canvas::stroke(Path path, LineStyle style) {
  if (is_drawable(path)) shapes_.emplace_back(Stroked{std::move(path), std::move(style)});
}

void Canvas::text(const Eigen::Vector2d& at, std::string_view text, const TextStyle& style) {
  if (at.allFinite() && !text.empty()) shapes_.emplace_back(Written{at, printable_utf8(text), style});
}

void Canvas::image(ImageRgb image, double x, double y, double width, double height) {
  const bool finite = std::isfinite(x) && std::isfinite(y) && std::isfinite(width) && std::isfinite(height);
  if (!finite || image.pixels.empty() || width <= 0.0 || height <= 0.0) return;
  shapes_.emplace_back(Pasted{std::move(image), x, y, width, height});
}

void Canvas::place(Canvas inner, double x, double y, double scale) {
  if (std::isfinite(x) && std::isfinite(y) && std::isfinite(scale) && scale > 0.0)
    shapes_.emplace_back(Placed{std::make_shared<const Canvas>(std::move(inner)), x, y, scale});
}

std::string Canvas::png(double zoom) const {
  return encode_png(pixels(zoom));
}

}  // namespace bodkin::imaging
