#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"

namespace bodkin::tracking {

// The conversion of light into grey levels by a camera. Light and level are fractions of white, 0 to 1.
struct ToneCurve {
  double exponent = 0.0;  // level = light^(1 / exponent), 1 to 3; 0: the sRGB curve (IEC 61966-2-1)
  double contrast = 0.0;  // share of an S-curve (3 x^2 - 2 x^3) mixed in after that, 0 to 1

  double level(double light) const;
  double light(double level) const;
  // Light of the 256 grey levels of a picture.
  std::array<float, 256> light_of_bytes() const;

  bool operator==(const ToneCurve&) const = default;
};

// The locked controls of a camera, in the units of its driver; absent: it has no such control.
struct CameraControls {
  std::optional<int> focus, exposure, gain, white_balance, sharpness;

  bool operator==(const CameraControls&) const = default;
};

// A camera with a lens: pinhole, Brown's distortion (Brown 1966, as OpenCV numbers it), tone curve and blur.
// Camera coordinates are mm, x to the right, y down, z forward; the centre of the upper left pixel is (0, 0).
struct CameraModel {
  int width = 0, height = 0;                                // pixels
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;            // pixels
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;  // distortion
  ToneCurve tone;
  double blur = 0.7;      // standard deviation of the optical blur, pixels
  double residual = 0.0;  // RMS of the calibration, pixels; 0: not calibrated from pictures
  CameraControls controls;

  // The pixel of a point in front of the camera (z > 0).
  Eigen::Vector2d project(const Vec3& point) const;
  // The direction (x, y, 1) of a pixel.
  Vec3 ray(const Eigen::Vector2d& pixel) const;

  bool operator==(const CameraModel&) const = default;
};

// A camera of the given size with a field of view of 65 degrees across, a lens with distortion and its principal
// point 1 % off the centre: the camera of rendered footage.
CameraModel footage_camera(int width, int height);

// x and y of the direction (x, y, 1) of every pixel, row by row.
std::vector<Eigen::Vector2f> ray_table(const CameraModel& camera);

// A camera as a JSON file. Reading throws InputError that names file and field.
CameraModel read_camera(const std::filesystem::path& file);
std::string camera_json(const CameraModel& camera);

}  // namespace bodkin::tracking
