#include "imaging/ultrasound_screen/scan_field.h"

#include <cmath>

namespace bodkin::imaging {

namespace {

constexpr int arc_pieces = 32;

Eigen::Vector2d on_arc(double centre, double radius, double angle) {
  return {radius * std::sin(angle), centre + radius * std::cos(angle)};
}

}  // namespace

std::vector<Eigen::Vector2d> field_of_view(const anatomy::UltrasoundProbe& probe, double depth) {
  const double half = 0.5 * probe.aperture();
  if (probe.kind == anatomy::ProbeKind::linear) return {{-half, 0.0}, {half, 0.0}, {half, depth}, {-half, depth}};
  std::vector<Eigen::Vector2d> corners;
  const bool curved = probe.kind == anatomy::ProbeKind::curvilinear;
  const double widest = curved ? half / probe.radius : 0.5 * probe.sector * degree;
  const double centre = curved ? -probe.radius : 0.0;
  const double inner = curved ? probe.radius : 0.0;
  for (int i = 0; i <= (curved ? arc_pieces : 0); ++i) {
    corners.push_back(on_arc(centre, inner, widest * (2.0 * i / arc_pieces - 1.0)));
  }
  for (int i = arc_pieces; i >= 0; --i) {
    corners.push_back(on_arc(centre, inner + depth, widest * (2.0 * i / arc_pieces - 1.0)));
  }
  return corners;
}

SlicePlane plane_of(const UltrasoundFrame& frame, const Pose& probe, OrientationMarkerSide mark) {
  SlicePlane plane;
  plane.pixel = frame.pixel;
  plane.width = frame.width;
  plane.height = frame.height;
  plane.right = probe.linear().col(0);
  plane.down = probe.linear().col(1);
  plane.corner = probe * frame.corner;
  if (mark == OrientationMarkerSide::left) {
    plane.corner += frame.pixel * (frame.width - 1) * plane.right;
    plane.right = -plane.right;
  }
  return plane;
}

ImageRgb grey_image(const UltrasoundFrame& frame, OrientationMarkerSide mark) {
  ImageRgb picture(frame.width, frame.height);
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const int from = mark == OrientationMarkerSide::left ? frame.width - 1 - column : column;
      const std::uint8_t grey = frame.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.width) +
                                             static_cast<std::size_t>(from)];
      picture.at(column, row) = {grey, grey, grey};
    }
  }
  return picture;
}

}  // namespace bodkin::imaging
