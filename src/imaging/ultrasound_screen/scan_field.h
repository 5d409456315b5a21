#pragma once

#include <vector>

#include "imaging/image_rgb.h"
#include "imaging/slice.h"
#include "imaging/ultrasound/frame.h"
#include "imaging/ultrasound/probe.h"

namespace bodkin::imaging {

// Where the probe's marked side stands in a picture.
enum class MarkSide : std::uint8_t { left, right };

// The border of what a probe sees down to `depth` mm, as corners of a closed line in the probe's frame (x, y), mm.
std::vector<Eigen::Vector2d> field_of_view(const anatomy::UltrasoundProbe& probe, double depth);

// The plane of a frame in the patient, pixel by pixel as the frame shows it: what imaging/slice.h cuts from the CT.
SlicePlane plane_of(const UltrasoundFrame& frame, const Pose& probe, MarkSide mark);

// The frame's pixels as they stand in a picture.
ImageRgb grey_picture(const UltrasoundFrame& frame, MarkSide mark);

}  // namespace bodkin::imaging
