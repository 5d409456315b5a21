#include "scene/camera.h"

#include <cmath>

namespace bodkin::scene {

Mat3 Camera::axes() const {
  const Vec3 away = (focus - eye).normalized();
  const Vec3 right = away.cross(up).normalized();
  Mat3 axes;
  axes << right, away.cross(right), away;
  return axes;
}

bool operator==(const Camera& a, const Camera& b) {
  return a.eye == b.eye && a.focus == b.focus && a.up == b.up && a.angle == b.angle;
}

Projection::Projection(const Camera& camera, int width, int height)
    : camera_(camera),
      width_(width),
      height_(height),
      axes_(camera.axes()),
      focal_(0.5 * height / std::tan(0.5 * camera.angle)) {}

double Projection::pixels_per_mm(const Vec3& point) const {
  const double away = axes_.col(2).dot(point - camera_.eye);
  return away >= nearest ? focal_ / away : 0.0;
}

std::optional<Place> Projection::place(const Vec3& point) const {
  const Vec3 seen = axes_.transpose() * (point - camera_.eye);
  if (!(seen.z() >= nearest)) return std::nullopt;
  const double nearness = 1.0 / seen.z();
  return Place{0.5 * width_ + focal_ * seen.x() * nearness, 0.5 * height_ + focal_ * seen.y() * nearness, nearness};
}

Vec3 Projection::point(const Place& place) const {
  const double away = 1.0 / place.nearness;
  const Vec3 seen((place.x - 0.5 * width_) / focal_ * away, (place.y - 0.5 * height_) / focal_ * away, away);
  return camera_.eye + axes_ * seen;
}

ViewRay Projection::ray(double x, double y) const {
  return {camera_.eye, (axes_ * Vec3(x - 0.5 * width_, y - 0.5 * height_, focal_)).normalized()};
}

std::optional<std::array<Place, 2>> Projection::line(const Vec3& a, const Vec3& b) const {
  const double from = axes_.col(2).dot(a - camera_.eye), to = axes_.col(2).dot(b - camera_.eye);
  if (!(from >= nearest) && !(to >= nearest)) return std::nullopt;
  const auto at_limit = [&] { return Vec3(a + (b - a) * ((nearest * (1.0 + 1e-9) - from) / (to - from))); };
  const std::optional<Place> first = place(from >= nearest ? a : at_limit());
  const std::optional<Place> second = place(to >= nearest ? b : at_limit());
  if (!first || !second) return std::nullopt;
  return std::array<Place, 2>{*first, *second};
}

}  // namespace bodkin::scene
