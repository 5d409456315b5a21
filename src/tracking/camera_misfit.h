#pragma once

#include <vector>

#include "tracking/grey_picture.h"
#include "tracking/pattern_rows.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// A number that was estimated, and its standard deviation; both 0 where it was not.
struct Estimate {
  double value = 0.0, deviation = 0.0;

  // It is further than `limit` from 0, and not by chance.
  bool exceeds(double limit) const;
};

// How a picture of a body differs from what the calibrated camera would make of it. The numbers are found together
// with the body's pose and the light on it, so that what these explain does not count.
struct CameraMisfit {
  // The tone curve: grey is too bright by this times m (1 - m) of the step from black to white, m being what the
  // pattern predicts from 0 to 1.
  Estimate tone;
  // Variance of the blur over the camera's, pixels squared; less than 0 where the picture is sharper.
  Estimate blur;
  // The focal length over the camera's, as a share of it. Only markers at different depths know it.
  Estimate focal;
};

// Of every `stride`-th pixel in both directions.
CameraMisfit camera_misfit(const PatternCamera& camera, const GreyPicture& picture,
                           const std::vector<FacePattern>& faces, const Pose& camera_from_body, int stride);

}  // namespace bodkin::tracking
