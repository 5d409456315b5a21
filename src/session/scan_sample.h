#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"
#include "imaging/ultrasound/scanned_parts.h"
#include "imaging/ultrasound/settings.h"

namespace bodkin::session {

// The pose of an ultrasound probe and the settings of its machine, from a time on until the next sample.
struct ScanSample {
  double time = 0.0;              // s of the session
  Pose probe = Pose::Identity();  // the probe's frame (anatomy/ultrasound_probe.h) to the patient, LPS
  imaging::UltrasoundSettings settings;
};

// A tissue or a structure of the segmentation that appeared in the machine's image.
struct ScannedPart {
  bool is_structure = false;  // false: a tissue
  std::string name;           // "nerve", "vertebrae_L3"
  double time = 0.0;          // s of the session, of its first appearance

  friend bool operator==(const ScannedPart&, const ScannedPart&) = default;
};

// The parts in `found` but not in `seen`, by name, first seen at `time` s; adds them to `seen`.
std::vector<ScannedPart> newly_scanned(const imaging::ScannedParts& found, imaging::ScannedParts& seen,
                                       const anatomy::Case& patient, double time);

}  // namespace bodkin::session
