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

// The oval of an image that contains the view into the patient (Sutherland et al. 2013, section II-E), pixels.
struct CutawayOval {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Vector2d radii = Eigen::Vector2d(125.0, 175.0);
  double threshold = 0.7;  // r_t: fraction of the radius up to which the view is opaque, 0 to below 1

  // Opacity of the view at a pixel, eq. 6: 1 up to the threshold, (1 - r) / (1 - r_t) to the rim, 0 outside; r is the
  // distance from the centre divided by the oval's radius in that direction.
  double opacity_at(const Eigen::Vector2d& pixel) const;
};

// A camera with its own pose, and rays according to its lens.
struct PictureCamera {
  Pose patient_from_camera = Pose::Identity();  // LPS mm
  double scale = 1.0;                           // mm in the patient per mm of the camera
  // Direction (x, y, 1) in camera axes of a pixel.
  std::function<Vec3(const Eigen::Vector2d&)> ray;
};

// The result of rays through an oval of an image: a view into the patient that is ready for blending, over more than
// one image if nothing has moved.
struct Cutaway {
  // Of one ray, 0 to 1.
  struct Light {
    float red = 0.0F, green = 0.0F, blue = 0.0F, opacity = 0.0F;
  };

  CutawayOval oval;
  int left = 0, top = 0, right = -1, bottom = -1;  // pixels of the image, both ends within; right < left: none
  int step = 1;                                    // pixels between rays; 2: the others are interpolated
  bool large = false;         // has more pixels than the largest number of rays, so that step is 2
  int columns = 0, rows = 0;  // of rays
  int rays = 0;               // number cast
  std::vector<Light> lights;  // row by row

  // Whether only every second pixel of every second row was cast.
  bool coarser() const { return step > 1; }
};

// The difference, 0 to 1, of the mean light at two neighbours of a ray from that at the two across from them, up to
// which the ray gets the mean of the four instead of being cast: four of the 255 levels of an image.
inline constexpr float little_bend = 4.0F / 255.0F;

// Casts the rays of the oval within an image of `width` x `height` pixels. An oval of more than `most_rays` pixels is
// cast at half the resolution, and so is one that `moves`. Every second ray of every second row is cast; of the
// others those whose neighbours differ by more than `most_bend` (0: at all; below: every one), weighted by the
// opacity of the view there: first those between four at their corners, then those between four at their sides. After
// Levoy 1990, "Volume rendering by adaptive refinement".
Cutaway cast_cutaway(const RayCaster& caster, const PictureCamera& camera, const CutawayOval& oval, int width,
                     int height, ThreadPool& pool, bool moves = false, int most_rays = 160000,
                     float most_bend = little_bend);

// Blends the view into the patient over an image of the size for which it was cast. Where a ray met nothing opaque,
// the image is not changed. Returns the number of pixels within the oval.
int blend_cutaway(const Cutaway& cutaway, ThreadPool& pool, ImageRgb& picture);

}  // namespace bodkin::imaging
