#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "core/geometry.h"

namespace bodkin::scene {

// The viewpoint: a pinhole camera, LPS mm.
struct Camera {
  Vec3 eye = Vec3(0.0, 600.0, 0.0);
  Vec3 focus = Vec3::Zero();      // the middle of the image, about which the camera turns
  Vec3 up = Vec3(0.0, 0.0, 1.0);  // need not be perpendicular to the line of sight, must not be parallel to it
  double angle = 30.0 * degree;   // rad, vertical field of view; above 0, below pi

  double distance() const { return (focus - eye).norm(); }
  // Columns: unit directions right, down and away from the viewer, a rotation.
  Mat3 axes() const;
};

bool operator==(const Camera& a, const Camera& b);

// A position in the image: pixels from its upper left corner, x to the right and y down, whole numbers at the corners
// of pixels; and its nearness 1 / distance along the line of sight (1/mm), which is linear in x and y on any plane.
struct Place {
  double x = 0.0, y = 0.0;
  double nearness = 0.0;

  Eigen::Vector2d pixel() const { return {x, y}; }
};

// A ray from the eye, LPS mm.
struct ViewRay {
  Vec3 origin = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  // unit
};

// A camera and its image.
class Projection {
 public:
  // `width` and `height`: pixels, at least 1.
  Projection(const Camera& camera, int width, int height);

  const Camera& camera() const { return camera_; }
  int width() const { return width_; }
  int height() const { return height_; }
  const Mat3& axes() const { return axes_; }
  // Pixels per mm at 1 mm from the eye.
  double focal_length() const { return focal_; }
  // Pixels per mm across the line of sight at `point`; 0 behind the eye.
  double pixels_per_mm(const Vec3& point) const;

  // Empty for a point less than `nearest` from the eye's plane.
  std::optional<Place> place(const Vec3& point) const;
  // A point that place() maps there.
  Vec3 point(const Place& place) const;
  ViewRay ray(double x, double y) const;
  // A line from a to b, clipped close to the eye's plane. Empty if all of it is too close.
  std::optional<std::array<Place, 2>> line(const Vec3& a, const Vec3& b) const;

  static constexpr double nearest = 5.0;  // mm

 private:
  Camera camera_;
  int width_, height_;
  Mat3 axes_;
  double focal_;
};

}  // namespace bodkin::scene
