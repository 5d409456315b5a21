#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"

namespace gdcm {
class DataSet;
}  // namespace gdcm

namespace bodkin::io {

// The placement of an image in the patient.
struct ImagePlacement {
  Vec3 position = Vec3::Zero();  // Image Position (Patient), LPS mm of the first pixel
  Vec3 row_direction = Vec3::UnitX(), column_direction = Vec3::UnitY();  // orthonormal, LPS
  double column_spacing = 0.0, row_spacing = 0.0;                        // mm along i and j
};

// The placement stated by a single-frame header; empty when a part is missing or invalid.
std::optional<ImagePlacement> read_placement(const gdcm::DataSet& data);

// One frame of a multi-frame image (DICOM PS3.3 C.7.6.16).
struct FrameInfo {
  ImagePlacement placement;
  double thickness = 0.0;  // mm, Slice Thickness; 0 = not given
  double slope = 1.0, intercept = 0.0;
  int segment = 0;  // of a segmentation: Referenced Segment Number
};

// All frames in the order of their pixels, from their shared and their own functional groups. Empty when there are
// none, or when the place of one is missing.
std::vector<FrameInfo> read_frames(const gdcm::DataSet& data);

}  // namespace bodkin::io
