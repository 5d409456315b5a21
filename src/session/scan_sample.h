#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"
#include "imaging/ultrasound/scanned_parts.h"
#include "imaging/ultrasound/settings.h"

namespace bodkin::session {

// How the probe of an ultrasound machine was held and how the machine was set, from a time on until the next sample.
struct ScanSample {
  double time = 0.0;              // s of the session
  Pose probe = Pose::Identity();  // the probe's frame (anatomy/ultrasound_probe.h) to the patient, LPS
  imaging::UltrasoundSettings settings;
};

// A tissue or a structure of the segmentation that came into the machine's picture.
struct ScannedPart {
  bool is_structure = false;  // false: a tissue
  std::string name;           // "nerve", "vertebrae_L3"
  double time = 0.0;          // s of the session, when it was there first

  friend bool operator==(const ScannedPart&, const ScannedPart&) = default;
};

// What `found` has and `seen` had not, by name, first seen at `time` s; and adds it to `seen`.
std::vector<ScannedPart> newly_scanned(const imaging::ScannedParts& found, imaging::ScannedParts& seen,
                                       const anatomy::Case& patient, double time);

}  // namespace bodkin::session
