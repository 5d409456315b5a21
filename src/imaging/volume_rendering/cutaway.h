#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/geometry.h"
#include "core/thread_pool.h"
#include "imaging/image_rgb.h"
#include "imaging/volume_rendering/ray_caster.h"

namespace bodkin::imaging {

// The oval of a picture in which the view into the patient stands (Sutherland et al. 2013, section II-E), pixels.
struct CutawayOval {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Vector2d radii = Eigen::Vector2d(125.0, 175.0);
  double threshold = 0.7;  // r_t: the share of the radius up to which the view is opaque, 0 to below 1

  // How opaque the view is at a pixel, eq. 6: 1 up to the threshold, (1 - r) / (1 - r_t) to the rim, 0 beyond; r is
  // the distance from the centre over the oval's radius in that direction.
  double opacity_at(const Eigen::Vector2d& pixel) const;
};

// A camera at a pose of its own that sees along rays of its own, those of its lens.
struct PictureCamera {
  Pose patient_from_camera = Pose::Identity();  // LPS mm
  double scale = 1.0;                           // mm in the patient for each mm of the camera
  // Direction (x, y, 1) in camera axes of a pixel.
  std::function<Vec3(const Eigen::Vector2d&)> ray;
};

// How a cutaway was drawn.
struct CutawayReport {
  int pixels = 0;        // within the oval and the picture
  int rays = 0;          // that were cast
  bool coarser = false;  // every second pixel of every second row was cast, and the rest interpolated
};

// Blends the view into the patient over `picture`, within the oval. Where a ray meets nothing opaque, the picture
// stays. An oval of more than `most_rays` pixels is cast at half the resolution. `moving`: at half the resolution in
// any case.
CutawayReport draw_cutaway(const RayCaster& caster, const PictureCamera& camera, const CutawayOval& oval,
                           ThreadPool& pool, ImageRgb& picture, bool moving = false, int most_rays = 160000);

}  // namespace bodkin::imaging
