#pragma once

#include <array>
#include <span>
#include <vector>

#include "tracking/camera_misfit.h"
#include "tracking/camera_model.h"
#include "tracking/grey_image.h"
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
  // RMS of image less model at the edges of the pattern, which determine the pose, as a fraction of the step from
  // black to white; and its ratio to the RMS elsewhere: 1 to 1.5 when only noise is left.
  double residual = 1.0, edge_ratio = 1.0;
  int pixels = 0;      // compared pixels
  bool sound = false;  // it converged, every used face is turned towards the camera and enough was visible
};

// Aligns the rendered pattern of a body's markers with an image. For every pixel of a visible face a ray is cast
// through the lens, and the pattern, blurred by the optics and by the pixel's own area (an ellipse on the face), is
// compared with the image's light, that is, its grey levels with the tone curve removed. Each face has an offset and
// a gain that is linear over it; they are eliminated. Gauss-Newton on the six numbers of the pose, with Huber
// weights. The start may be off by at most a pixel or two, which the corners of the markers ensure.
class PhotometricRefinement {
 public:
  explicit PhotometricRefinement(const CameraModel& camera);

  // `ids`: the markers of the body to use, those that were found. `steps`: limit of Gauss-Newton steps.
  RefinedPose refine(const GreyImage& picture, const MarkerBody& body, std::span<const int> ids, const Pose& start,
                     int steps = 4) const;

  // The differences of the image of a body at its pose from the prediction by the calibrated camera.
  CameraMisfit misfit(const GreyImage& picture, const MarkerBody& body, std::span<const int> ids,
                      const RefinedPose& pose) const;

  const CameraModel& camera() const { return camera_; }
  // Sets another tone curve and blur of the same lens.
  void set_light(const ToneCurve& tone, double blur);

 private:
  struct Sums;  // data gathered by one step
  bool gather(const GreyImage& picture, const FacePattern& face, const Pose& camera_from_body, int stride,
              Sums& sums) const;

  PatternCamera pattern_camera() const { return {camera_, rays_, light_, variance_}; }

  CameraModel camera_;
  std::vector<Eigen::Vector2f> rays_;
  std::array<float, 256> light_{};
  double variance_;  // of blur and pixel together, pixels squared
};

}  // namespace bodkin::tracking
