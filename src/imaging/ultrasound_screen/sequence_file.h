#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"

namespace bodkin::imaging {

// One frame of a tracked sequence.
struct TrackedFrame {
  double time = 0.0;                 // s
  Pose probe = Pose::Identity();     // probe to patient, LPS
  bool valid = true;                 // the pose is known
  std::optional<Pose> needle;        // tip and axis, patient, LPS
  std::vector<std::uint8_t> pixels;  // height x width, MF: columns towards the marker, rows into the depth
};

// Images of one size with the poses of the probe: the format that PLUS records and 3D Slicer plays.
struct TrackedSequence {
  int width = 0, height = 0;   // pixels
  double pixel = 0.0;          // mm
  Vec3 corner = Vec3::Zero();  // mm, centre of the top left pixel in the probe's frame
  std::string probe;           // "C5-2"
  double depth = 0.0;          // mm shown
  std::vector<TrackedFrame> frames;
};

// The bytes of a MetaImage sequence (.igs.mha) in the format of PLUS. "Reference" is the patient in RAS, mm, as 3D
// Slicer shows the CT; "Image" is in pixels, "Probe" is the probe's frame (PLUS's Transducer), in mm; "NeedleTip" has
// its third axis in the direction of insertion. Throws InputError when there is no frame or one has another size than
// the others.
std::string sequence_bytes(const TrackedSequence& sequence, bool compressed);

}  // namespace bodkin::imaging
