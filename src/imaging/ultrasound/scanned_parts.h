#pragma once

#include <array>
#include <bitset>
#include <set>

#include "anatomy/case.h"
#include "anatomy/ultrasound_probe.h"
#include "imaging/ultrasound/settings.h"

namespace bodkin::imaging {

// The tissues and structures that appeared in the images of a probe.
struct ScannedParts {
  std::bitset<256> tissues;            // by id
  std::set<std::uint16_t> structures;  // labels of the segmentation
};

// Finds which tissues and structures of a patient at rest the scan lines of a probe meet. A line runs from the
// probe's face through gel and tissue to the depth that the machine shows, and ends where hardly any sound continues:
// at bone, metal or gas, which are included. Lines from a part of the face that does not touch skin or gel meet
// nothing.
class ScannedSearch {
 public:
  // `patient` must outlive the object.
  ScannedSearch(const anatomy::Case& patient, const anatomy::UltrasoundProbe& probe);

  // Adds to `parts` what the probe at `pose` (probe to patient, LPS) meets. Nothing for a pose that is not finite.
  void add(const Pose& pose, const UltrasoundSettings& settings, ScannedParts& parts) const;

 private:
  const anatomy::Case& patient_;
  anatomy::UltrasoundProbe probe_;
  std::array<bool, 256> ends_line_{};  // by tissue id
  double step_ = 1.0;                  // mm along a line
};

}  // namespace bodkin::imaging
