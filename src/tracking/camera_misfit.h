#pragma once

#include <vector>

#include "tracking/grey_image.h"
#include "tracking/pattern_rows.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// An estimated number and its standard deviation; both 0 if not estimated.
struct Estimate {
  double value = 0.0, deviation = 0.0;

  // Whether it is farther than `limit` from 0, significantly.
  bool exceeds(double limit) const;
};

// The differences of an image of a body from the prediction by the calibrated camera. They are estimated together
// with the body's pose and its lighting, so that differences explained by these do not count.
struct CameraMisfit {
  // The tone curve: grey is too bright by this times m (1 - m) of the step from black to white, m being the
  // prediction of the pattern from 0 to 1.
  Estimate tone;
  // Excess of the blur's variance over the camera's, pixels squared; negative in a sharper image.
  Estimate blur;
  // Excess of the focal length over the camera's, as a fraction of it. Only markers at different depths determine it.
  Estimate focal;
};

// From every `stride`-th pixel in both directions.
CameraMisfit camera_misfit(const PatternCamera& camera, const GreyImage& picture,
                           const std::vector<FacePattern>& faces, const Pose& camera_from_body, int stride);

}  // namespace bodkin::tracking
