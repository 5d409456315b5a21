#pragma once

#include <array>
#include <bitset>
#include <set>

#include "anatomy/case.h"
#include "anatomy/ultrasound_probe.h"
#include "imaging/ultrasound/settings.h"

namespace bodkin::imaging {

// What came into the pictures of a probe.
struct ScannedParts {
  std::bitset<256> tissues;            // by id
  std::set<std::uint16_t> structures;  // labels of the segmentation
};

// Finds which tissues and structures of a patient, as he lies at rest, the scanlines of a probe meet. A line runs
// from the probe's face through gel and tissue to the depth that the machine shows, and ends where hardly any sound
// goes on: at bone, metal or gas, which are met themselves. Lines whose part of the face does not touch skin or gel
// meet nothing.
class ScannedSearch {
 public:
  // `patient` must outlive the object.
  ScannedSearch(const anatomy::Case& patient, const anatomy::UltrasoundProbe& probe);

  // Adds what the probe at `pose` (probe to patient, LPS) meets to `parts`. A pose that is not finite meets nothing.
  void add(const Pose& pose, const UltrasoundSettings& settings, ScannedParts& parts) const;

 private:
  const anatomy::Case& patient_;
  anatomy::UltrasoundProbe probe_;
  std::array<bool, 256> ends_line_{};  // by tissue id
  double step_ = 1.0;                  // mm along a line
};

}  // namespace bodkin::imaging
