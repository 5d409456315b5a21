#include "scene/strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace bodkin::scene {

namespace {

using Eigen::Vector2d;

// A rod in the picture.
struct FlatRod {
  Vector2d from, along;                   // pixels; unit
  double length;                          // pixels
  double half_width_from, half_width_to;  // pixels
  bool round;                             // seen along its axis: a disc
};

// The x on row y that the rod may cover.
std::array<double, 2> span_on_row(const FlatRod& rod, double y, double reach) {
  // Where |across| <= reach and -reach <= along <= length + reach, both linear in x.
  std::array<double, 2> span = {-1e9, 1e9};
  const auto keep = [&](double slope, double offset, double low, double high) {
    if (std::abs(slope) < 1e-9) {
      if (offset < low || offset > high) span = {1.0, 0.0};
      return;
    }
    double first = (low - offset) / slope, last = (high - offset) / slope;
    if (first > last) std::swap(first, last);
    span = {std::max(span[0], first), std::min(span[1], last)};
  };
  const double down = y - rod.from.y();
  // relative to rod.from.x()
  keep(-rod.along.y(), rod.along.x() * down, -reach, reach);
  keep(rod.along.x(), rod.along.y() * down, -reach, rod.length + reach);
  return {rod.from.x() + span[0], rod.from.x() + span[1]};
}

double share_of_pixel(double inside) {
  return std::clamp(inside + 0.5, 0.0, 1.0);
}

double covered(const FlatRod& rod, double p, double q, double half_width) {
  if (rod.round) {
    const double beyond = p < 0.0 ? -p : std::max(0.0, p - rod.length);
    return share_of_pixel(half_width - std::hypot(beyond, q));
  }
  // Rods narrower than a pixel cover a fraction of it.
  return std::min(1.0, 2.0 * half_width) * share_of_pixel(half_width - std::abs(q)) * share_of_pixel(p) *
         share_of_pixel(rod.length - p);
}

}  // namespace

void draw_rod(const Rod& rod, const RodColour& colour, const Projection& projection, MovingPixels& pixels) {
  const std::optional<std::array<Place, 2>> ends = projection.line(rod.from, rod.to);
  if (!ends) return;
  const auto& [first, last] = *ends;
  const Vec3 cut_from = projection.point(first), cut_to = projection.point(last);
  const double start = (cut_from - rod.from).norm(), length = (cut_to - cut_from).norm();
  const auto half_width = [&](const Place& place) {
    return std::max(0.5 * rod.least_width, rod.radius * projection.focal_length() * place.nearness);
  };
  FlatRod flat{first.pixel(), last.pixel() - first.pixel(), 0.0, half_width(first), half_width(last), false};
  flat.length = flat.along.norm();
  flat.round = flat.length < 0.5 * std::max(flat.half_width_from, flat.half_width_to);
  flat.along = flat.length > 1e-6 ? Vector2d(flat.along / flat.length) : Vector2d::UnitX();
  const double reach = std::max(flat.half_width_from, flat.half_width_to) + 1.0;
  const double top = std::min(first.y, last.y) - reach, bottom = std::max(first.y, last.y) + reach;
  const int first_row = static_cast<int>(std::clamp(std::floor(top), 0.0, 1.0 * pixels.height()));
  const int end_row = static_cast<int>(std::clamp(std::ceil(bottom), 0.0, 1.0 * pixels.height()));
  for (int y = first_row; y < end_row; ++y) {
    const std::array<double, 2> span = span_on_row(flat, y + 0.5, reach);
    const int left = static_cast<int>(std::clamp(std::floor(span[0]), 0.0, 1.0 * pixels.width()));
    const int right = static_cast<int>(std::clamp(std::ceil(span[1]), 0.0, 1.0 * pixels.width()));
    for (int x = left; x < right; ++x) {
      const Vector2d from = Vector2d(x + 0.5, y + 0.5) - flat.from;
      const double p = from.dot(flat.along), q = flat.along.x() * from.y() - flat.along.y() * from.x();
      const double t = flat.length > 1e-6 ? std::clamp(p / flat.length, 0.0, 1.0) : 0.0;
      const double half = flat.half_width_from + t * (flat.half_width_to - flat.half_width_from);
      const double part = covered(flat, p, q, half);
      if (part <= 0.0) continue;
      const double nearness = first.nearness + t * (last.nearness - first.nearness);
      const double along =
          start + length * t * last.nearness / nearness;  // what is linear in space is not on the screen
      float opacity = 1.0F;
      const std::uint32_t shade = colour(along, std::clamp(q / half, -1.0, 1.0), opacity);
      pixels.add(x, y, static_cast<float>(nearness), shade, opacity * static_cast<float>(part), rod.behind);
    }
  }
}

void draw_line(std::span<const Vec3> points, const Line& line, const Projection& projection, MovingPixels& pixels) {
  double before = 0.0;  // mm, length of the line so far
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Rod rod{points[i], points[i + 1], 0.0, line.width, line.behind};
    const auto colour = [&](double along, double, float& opacity) {
      opacity = line.opacity;
      if (line.dash > 0.0 && std::fmod(before + along, 2.0 * line.dash) >= line.dash) opacity = 0.0F;
      return line.colour;
    };
    draw_rod(rod, colour, projection, pixels);
    before += (points[i + 1] - points[i]).norm();
  }
}

void draw_circle(const Vec3& centre, const Vec3& axis, double radius, const Line& line, const Projection& projection,
                 MovingPixels& pixels) {
  constexpr int corners = 48;
  const Vec3 u = axis.unitOrthogonal() * radius, v = axis.normalized().cross(u);
  std::vector<Vec3> points;
  for (int i = 0; i <= corners; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / corners;
    points.push_back(centre + std::cos(turn) * u + std::sin(turn) * v);
  }
  draw_line(points, line, projection, pixels);
}

}  // namespace bodkin::scene
