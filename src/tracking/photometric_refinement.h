#pragma once

#include <array>
#include <span>
#include <vector>

#include "tracking/camera_misfit.h"
#include "tracking/camera_model.h"
#include "tracking/grey_picture.h"
#include "tracking/marker_body.h"
#include "tracking/pattern_rows.h"
#include "tracking/pose_step.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// A pose after refinement.
struct RefinedPose {
  Pose camera_from_body = Pose::Identity();
  // Of a shift (mm) and a rotation (rotation vector, radians) about the body's origin, both along the camera's axes.
  Matrix6 covariance = Matrix6::Zero();
  // RMS of picture less model where the pattern has edges, which the pose is read from, as a share of the step from
  // black to white; and the same over that where it has none: 1 to 1.5 when nothing but noise is left.
  double residual = 1.0, edge_ratio = 1.0;
  int pixels = 0;      // that were compared
  bool sound = false;  // it came to rest, every used face looks at the camera and there was enough to see
};

// Aligns the rendered pattern of a body's markers with a picture. For every pixel of a visible face a ray is cast
// through the lens, and the pattern, blurred by the optics and by the pixel's own area (an ellipse on the face), is
// compared with the picture's light, that is, its grey levels with the tone curve taken out. Each face has an offset
// and a gain that is linear over it; they are eliminated. Gauss-Newton on the six numbers of the pose, with Huber
// weights. It needs a start that is off by a pixel or two at most, which the corners of the markers give.
class PhotometricRefinement {
 public:
  explicit PhotometricRefinement(const CameraModel& camera);

  // `ids`: the markers of the body to use, those that were found. `steps`: of Gauss-Newton, at most.
  RefinedPose refine(const GreyPicture& picture, const MarkerBody& body, std::span<const int> ids, const Pose& start,
                     int steps = 4) const;

  // How the picture of a body at its pose differs from what the calibrated camera would make of it.
  CameraMisfit misfit(const GreyPicture& picture, const MarkerBody& body, std::span<const int> ids,
                      const RefinedPose& pose) const;

  const CameraModel& camera() const { return camera_; }
  // Another tone curve and blur of the same lens.
  void set_light(const ToneCurve& tone, double blur);

 private:
  struct Sums;  // what one step gathers
  bool gather(const GreyPicture& picture, const FacePattern& face, const Pose& camera_from_body, int stride,
              Sums& sums) const;

  PatternCamera pattern_camera() const { return {camera_, rays_, light_, variance_}; }

  CameraModel camera_;
  std::vector<Eigen::Vector2f> rays_;
  std::array<float, 256> light_{};
  double variance_;  // of blur and pixel together, pixels squared
};

}  // namespace bodkin::tracking
