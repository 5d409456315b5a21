#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tracking/camera_model.h"
#include "tracking/grey_image.h"
#include "tracking/marker_body.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// A marker as compared with a camera's pixels: its cells and the margin of its sheet, one cell on every side.
struct FacePattern {
  static constexpr int padded = marker_cells + 2;

  const MarkerFace* face = nullptr;
  Vec3 body_origin = Vec3::Zero();  // in the face's frame
  float cells[padded][padded] = {};
};

// The patterns of those of the markers that the body has.
std::vector<FacePattern> patterns_of(const MarkerBody& body, std::span<const int> ids);

// A pixel of a marker: its light in the image, and the prediction of the pattern.
struct PatternRow {
  float light = 0.0F, model = 0.0F, u = 0.0F, v = 0.0F;  // u, v: from -1 to 1 over the black square
  float slope[6] = {};                                   // of the model by the pose, in the face's axes
  std::uint32_t pixel = 0;                               // of the picture
};

// A camera for rendering patterns: a ray of each pixel, the light of each grey level, and the variance (pixels
// squared) of its blur and a pixel's own area together.
struct PatternCamera {
  const CameraModel& camera;
  const std::vector<Eigen::Vector2f>& rays;
  const std::array<float, 256>& light;
  double variance;
};

// The pixels of a face at a pose, every `stride`-th in both directions; none if it is not in front of the camera.
void gather_rows(const PatternCamera& camera, const GreyImage& picture, const FacePattern& face,
                 const Pose& camera_from_body, int stride, std::vector<PatternRow>& rows);

// A face with fewer pixels is not used.
inline constexpr std::size_t least_rows = 60;

// The light of a face: a gain that is linear over it and an offset, so that light = (l0 + l1 u + l2 v) model + l3.
struct FaceLight {
  Eigen::Vector4d light = Eigen::Vector4d::Zero();
  double scale = 1.0;  // of the residuals, as a standard deviation
};
FaceLight fit_light(const std::vector<PatternRow>& rows);

}  // namespace bodkin::tracking
