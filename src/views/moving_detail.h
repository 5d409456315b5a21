#pragma once

namespace bodkin::views {

// How coarse the pictures of a volume are while the camera moves, so that 25 of them a second can be drawn on a
// machine that is slow, busy, or has a volume before it through which light passes for long. Steps along the rays
// become longer first, up to twice; then there are fewer rays.
class MovingDetail {
 public:
  static constexpr double finest_step = 2.0;      // voxels
  static constexpr double most_rays = 256 * 256;  // of a picture
  static constexpr double in_time = 0.033;        // s for a picture; the rest of 1/25 s is for scaling and the window

  // A moving picture has been drawn, in so many s.
  void took(double seconds);

  double step() const;  // voxels, 2 to 4
  double rays() const;  // 256^2 / 3 to 256^2

 private:
  double coarseness_ = 1.0;  // by which a picture should take less time than the finest one; 1 to 6
};

}  // namespace bodkin::views
