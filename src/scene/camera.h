#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "core/geometry.h"

namespace bodkin::scene {

// From where the patient is seen: a pinhole camera, LPS mm.
struct Camera {
  Vec3 eye = Vec3(0.0, 600.0, 0.0);
  Vec3 focus = Vec3::Zero();      // the middle of the picture, about which the camera turns
  Vec3 up = Vec3(0.0, 0.0, 1.0);  // need not be perpendicular to the line of sight, must not be parallel to it
  double angle = 30.0 * degree;   // rad that the picture is high; above 0, below pi

  double distance() const { return (focus - eye).norm(); }
  // Columns: unit directions right, down and away from the viewer, a rotation.
  Mat3 axes() const;
};

bool operator==(const Camera& a, const Camera& b);

// A place in the picture: pixels from its upper left corner, x to the right and y down, whole numbers at the corners
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

// A camera and the picture that it makes.
class Projection {
 public:
  // `width` and `height`: pixels, at least 1.
  Projection(const Camera& camera, int width, int height);

  const Camera& camera() const { return camera_; }
  int width() const { return width_; }
  int height() const { return height_; }
  const Mat3& axes() const { return axes_; }
  // Pixels that 1 mm takes at 1 mm from the eye.
  double focal_length() const { return focal_; }
  // Pixels that a length of 1 mm across the line of sight takes at `point`; 0 behind the eye.
  double pixels_per_mm(const Vec3& point) const;

  // Nothing for a point less than `nearest` from the eye's plane.
  std::optional<Place> place(const Vec3& point) const;
  // A point that place() shows there.
  Vec3 point(const Place& place) const;
  ViewRay ray(double x, double y) const;
  // A line from a to b, cut where it comes too near to the eye's plane. Nothing where all of it does.
  std::optional<std::array<Place, 2>> line(const Vec3& a, const Vec3& b) const;

  static constexpr double nearest = 5.0;  // mm

 private:
  Camera camera_;
  int width_, height_;
  Mat3 axes_;
  double focal_;
};

}  // namespace bodkin::scene
