#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

// Parameters of a synthetic lumbar torso. They determine difficulty and variety.
struct LumbarParameters {
  std::uint64_t seed = 1;  // small variations of every size, and the noise of the HU
  double age = 45.0;       // years, 18 to 95: disc height, bone density, ligament fat, facet size
  double height = 1.72;    // m, 1.40 to 2.05: scales the vertebrae
  double weight = 72.0;    // kg, 40 to 160: with height, thickness of the subcutaneous fat
  double flexion = 0.5;    // 0 = prone and straight, 1 = fully curled: opens the interspinous spaces
  // Degrees of Cobb's angle, -40 to 40: the spine bows sideways, to the left if above 0, and rotates with it.
  double scoliosis = 0.0;
  // 0 to 1: the calcified fraction of the supraspinous and interspinous ligaments, from behind.
  double calcification = 0.0;
  // mm across, 0 (none) or 8 to 30: a lesion next to the left psoas at L3, behind the peritoneum, for biopsies.
  double lesion = 0.0;
  double spacing = 1.0;  // mm, isotropic voxels, 0.5 to 3
};

struct SyntheticPatient {
  anatomy::CtVolume ct;
  anatomy::LabelVolume structures;  // TotalSegmentator ids if it has one
  std::vector<anatomy::Structure> structure_table;
  anatomy::TissueVolume tissues;
  std::vector<anatomy::Landmark> landmarks;  // names as from build_patient, and "conus"
  anatomy::NeedlePath path;                  // planned lumbar puncture at L3/L4, midline
};

// The same parameters give the same voxels on every machine. HU and their noise come from `library`, which for a
// calcification above 0 must have the calcified ligament (with_calcified_ligament). Throws InputError naming the
// parameter, its value and its range.
SyntheticPatient synthesize_lumbar(const LumbarParameters& parameters, const anatomy::TissueLibrary& library,
                                   const Progress& progress = {});

}  // namespace bodkin::patient
