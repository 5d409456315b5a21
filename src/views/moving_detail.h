#pragma once

namespace bodkin::views {

// The coarseness of a volume's images while the camera moves, so that 25 of them a second can be drawn on a slow or
// busy machine, or with a very transparent volume. Steps along the rays become longer first, up to twice; then the
// number of rays is reduced.
class MovingDetail {
 public:
  static constexpr double finest_step = 2.0;      // voxels
  static constexpr double most_rays = 256 * 256;  // of an image
  static constexpr double in_time = 0.033;        // s for an image; the rest of 1/25 s is for scaling and the window

  // Reports the duration of drawing a moving image, s.
  void took(double seconds);

  double step() const;  // voxels, 2 to 4
  double rays() const;  // 256^2 / 3 to 256^2

 private:
  double coarseness_ = 1.0;  // required reduction of an image's time relative to the finest one; 1 to 6
};

}  // namespace bodkin::views
