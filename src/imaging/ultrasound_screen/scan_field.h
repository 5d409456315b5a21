#pragma once

#include <vector>

#include "imaging/image_rgb.h"
#include "imaging/slice.h"
#include "imaging/ultrasound/frame.h"
#include "imaging/ultrasound/probe.h"

namespace bodkin::imaging {

// The side of an image on which the probe's orientation marker is.
enum class OrientationMarkerSide : std::uint8_t { left, right };

// The border of a probe's field of view down to `depth` mm, as corners of a closed line in the probe's frame (x, y),
// mm.
std::vector<Eigen::Vector2d> field_of_view(const anatomy::UltrasoundProbe& probe, double depth);

// The plane of a frame in the patient, pixel by pixel as in the frame: for cutting the CT with imaging/slice.h.
SlicePlane plane_of(const UltrasoundFrame& frame, const Pose& probe, OrientationMarkerSide mark);

// The frame's pixels in the orientation of an image.
ImageRgb grey_image(const UltrasoundFrame& frame, OrientationMarkerSide mark);

}  // namespace bodkin::imaging
