#include "views/slice_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace bodkin::views {

namespace {

imaging::View view_of(SliceKind kind) {
  switch (kind) {
    case SliceKind::axial:
      return imaging::View::axial;
    case SliceKind::coronal:
      return imaging::View::coronal;
    case SliceKind::sagittal:
    case SliceKind::along_needle:
      break;
  }
  return imaging::View::sagittal;
}

}  // namespace

imaging::SlicePlane slice_plane(SliceKind kind, const SliceWindow& window, const Vec3& axis) {
  const double pixel = window.field / std::max({window.width, window.height, 1});
  const double width = pixel * window.width, height = pixel * window.height;
  if (kind != SliceKind::along_needle) {
    return imaging::view_plane(view_of(kind), window.middle, width, height, pixel);
  }
  return imaging::sagittal_plane_along({window.middle, window.middle + axis}, window.middle, width, height, pixel);
}

Vec3 middle_through(const imaging::SlicePlane& plane, const Vec3& middle, const Vec3& point) {
  return middle + plane.normal().dot(point - middle) * plane.normal();
}

Vec3 middle_that_shows(const imaging::SlicePlane& plane, const Vec3& middle, const Vec3& point, double margin) {
  const Eigen::Vector2d place = plane.place(point);
  const Eigen::Vector2d size(plane.width, plane.height);
  const Eigen::Vector2d edge = margin * size;
  const bool seen = (place.array() >= edge.array()).all() && (place.array() <= (size - edge).array()).all();
  return seen ? middle_through(plane, middle, point) : point;
}

NeedleOnSlice project_needle(const imaging::SlicePlane& plane, const Vec3& tip, const Vec3& hub, double thickness) {
  constexpr double between_ticks = 10.0;  // mm
  NeedleOnSlice needle;
  needle.tip = plane.place(tip);
  needle.hub = plane.place(hub);
  needle.distance = plane.distance(tip);
  const double length = (hub - tip).norm();
  if (!(length > 0.0)) return needle;
  const Vec3 axis = (hub - tip) / length;
  const Eigen::Vector2d seen = needle.hub - needle.tip;
  needle.foreshortening = seen.norm() * plane.pixel / length;
  if (seen.norm() > 1e-6) needle.along = seen.normalized();
  const auto near = [&](double along) { return std::abs(plane.distance(tip + along * axis)) <= thickness; };
  // The shaft leaves the layer about the plane at most twice.
  std::vector<double> ends = {0.0};
  const double step = plane.normal().dot(axis);
  if (std::abs(step) > 1e-9) {
    std::array<double, 2> crossings = {(-thickness - needle.distance) / step, (thickness - needle.distance) / step};
    std::sort(crossings.begin(), crossings.end());
    for (const double crossing : crossings) {
      if (crossing > ends.back() && crossing < length) ends.push_back(crossing);
    }
  }
  ends.push_back(length);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    needle.pieces.push_back({plane.place(tip + ends[i] * axis), plane.place(tip + ends[i + 1] * axis),
                             near(0.5 * (ends[i] + ends[i + 1]))});
  }
  for (double along = between_ticks; along < length; along += between_ticks) {
    needle.ticks.push_back({plane.place(tip + along * axis), static_cast<int>(std::lround(along)), near(along)});
  }
  return needle;
}

double scale_bar(double millimetres_a_pixel, double most) {
  constexpr std::array<double, 7> lengths = {100.0, 50.0, 20.0, 10.0, 5.0, 2.0, 1.0};
  for (const double length : lengths) {
    if (length <= most * millimetres_a_pixel) return length;
  }
  return lengths.back();
}

std::string position_text(const imaging::SlicePlane& plane, const Vec3& middle) {
  constexpr std::array<std::array<const char*, 2>, 3> letters = {{{"L", "R"}, {"P", "A"}, {"S", "I"}}};
  Eigen::Index axis = 0;
  plane.normal().cwiseAbs().maxCoeff(&axis);
  const double place = middle[axis];
  return fmt::format("{} {:.1f}", letters[static_cast<std::size_t>(axis)][place < 0.0 ? 1 : 0], std::abs(place));
}

}  // namespace bodkin::views
