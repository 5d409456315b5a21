#pragma once

#include <cstdint>
#include <vector>

#include "tracking/camera_model.h"
#include "tracking/grey_image.h"
#include "tracking/marker_body.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// Synthetic images of marker bodies with the defects of real ones. Sheets are ray-cast through the lens with
// `samples` x `samples` rays for each pixel; then blur, noise, the tone curve and 8 bits are applied.
struct FootageLook {
  int samples = 6;            // along each side of a pixel, 1 to 12
  double shot_noise = 0.016;  // standard deviation of the noise of white, share of white
  double read_noise = 0.004;  // of black; together about 2.5 grey levels
  double exposure = 1.0;      // light of the images relative to the usual
  double sharpening = 0.0;    // unsharp mask that the camera applies to its grey levels, 0 to 2
  double unevenness = 0.25;   // fall of the light from the middle of the picture to its corners, 0 to 0.9
  int instants = 1;           // number of times during the exposure at which a moving body is drawn, 1 to 32
  int jpeg_quality = 85;      // 1 to 100; 0: not compressed
  double occlusion = 0.0;     // fraction of the bodies hidden by a finger, 0 to 0.9
};

// A body in the image. It moves during the exposure by `shift` (mm) and `turn` (rotation vector, radians), both in
// camera axes and about the body's origin; the given place is that of the exposure's middle.
struct PlacedBody {
  const MarkerBody* body = nullptr;
  Pose camera_from_body = Pose::Identity();
  Vec3 shift = Vec3::Zero(), turn = Vec3::Zero();
};

// The image of these bodies by this camera. The same arguments give the same image on every machine.
GreyImage render_picture(const CameraModel& camera, const FootageLook& look, const std::vector<PlacedBody>& bodies,
                         std::uint64_t seed);

}  // namespace bodkin::tracking
