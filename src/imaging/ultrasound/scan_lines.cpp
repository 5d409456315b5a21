#include "imaging/ultrasound/scan_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bodkin::imaging {

Vec3 ScanLines::origin(double line) const {
  const double at = first + step * line;
  if (kind == anatomy::ProbeKind::linear) return {at, 0.0, 0.0};
  return {radius * std::sin(at), radius * (std::cos(at) - 1.0), 0.0};
}

Vec3 ScanLines::direction(double line) const {
  if (kind == anatomy::ProbeKind::linear) return Vec3::UnitY();
  const double at = first + step * line;
  return {std::sin(at), std::cos(at), 0.0};
}

double ScanLines::apart(double depth) const {
  return kind == anatomy::ProbeKind::linear ? step : step * (radius + depth);
}

Eigen::Vector2d ScanLines::place(const Vec3& point) const {
  if (kind == anatomy::ProbeKind::linear) return {(point.x() - first) / step, point.y() / spacing};
  const double across = point.x(), along = point.y() + radius;
  return {(std::atan2(across, along) - first) / step, (std::hypot(across, along) - radius) / spacing};
}

ScanLines scan_lines(const anatomy::UltrasoundProbe& probe, const UltrasoundSettings& settings,
                     const UltrasoundDetail& detail) {
  ScanLines lines;
  lines.kind = probe.kind;
  lines.radius = probe.kind == anatomy::ProbeKind::curvilinear ? probe.radius : 0.0;
  lines.lines = detail.lines;
  lines.samples = detail.samples;
  lines.spacing = settings.depth / (detail.samples - 1);
  double whole = probe.aperture();
  if (probe.kind == anatomy::ProbeKind::curvilinear) whole /= probe.radius;
  if (probe.kind == anatomy::ProbeKind::phased) whole = probe.sector * degree;
  lines.first = -0.5 * whole;
  lines.step = whole / (detail.lines - 1);
  return lines;
}

ScanConversion scan_conversion(const ScanLines& lines, int width, int height, int stride) {
  const double depth = lines.spacing * (lines.samples - 1);
  double low_x = std::numeric_limits<double>::infinity(), high_x = -low_x, low_y = low_x, high_y = -low_x;
  for (int line = 0; line < lines.lines; ++line) {
    for (const double far : {0.0, depth}) {
      const Vec3 point = lines.origin(line) + far * lines.direction(line);
      low_x = std::min(low_x, point.x());
      high_x = std::max(high_x, point.x());
      low_y = std::min(low_y, point.y());
      high_y = std::max(high_y, point.y());
    }
  }
  ScanConversion picture;
  picture.width = width;
  picture.height = height;
  picture.pixel = std::max((high_x - low_x) / (width - 1), (high_y - low_y) / (height - 1));
  picture.corner = {0.5 * (low_x + high_x) - 0.5 * picture.pixel * (width - 1), low_y, 0.0};

  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  picture.place.assign(pixels, 0);
  picture.weights.assign(2 * pixels, 0);
  constexpr double slack = 1e-6;  // lines, samples: the outermost pixels lie on the outermost lines
  std::size_t at = 0;
  for (int row = 0; row < height; ++row) {
    picture.row_of_runs.push_back(picture.runs.size());
    bool running = false;
    for (int column = 0; column < width; ++column, ++at) {
      const Eigen::Vector2d place = lines.place(picture.corner + picture.pixel * Vec3(column, row, 0.0));
      const bool seen = place.x() >= -slack && place.x() <= lines.lines - 1 + slack && place.y() >= -slack &&
                        place.y() <= lines.samples - 1 + slack;
      if (seen && !running) picture.runs.push_back({at, at});
      running = seen;
      if (!seen) continue;
      picture.runs.back().last = at + 1;
      const double line = std::clamp(place.x(), 0.0, lines.lines - 1.0);
      const double sample = std::clamp(place.y(), 0.0, lines.samples - 1.0);
      const int near_line = std::min(static_cast<int>(line), lines.lines - 2);
      const int near_sample = std::min(static_cast<int>(sample), lines.samples - 2);
      picture.place[at] = near_sample * stride + near_line;
      picture.weights[2 * at] = static_cast<std::uint8_t>(std::min(255.0, std::round(256.0 * (line - near_line))));
      picture.weights[2 * at + 1] =
          static_cast<std::uint8_t>(std::min(255.0, std::round(256.0 * (sample - near_sample))));
    }
  }
  picture.row_of_runs.push_back(picture.runs.size());
  return picture;
}

}  // namespace bodkin::imaging
