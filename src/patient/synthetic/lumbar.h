#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin {

// What a synthetic lumbar torso is made from. Difficulty and variety come from these.
struct LumbarParameters {
  std::uint64_t seed = 1;  // small variations of every size, and the noise of the HU
  double age = 45.0;       // years, 18 to 95: disc height, bone density, ligament fat, facet size
  double height = 1.72;    // m, 1.40 to 2.05: scales the vertebrae
  double weight = 72.0;    // kg, 40 to 160: with height, thickness of the subcutaneous fat
  double flexion = 0.5;    // 0 = prone and straight, 1 = fully curled: opens the interspinous spaces
  double spacing = 1.0;    // mm, isotropic voxels, 0.5 to 3
};

struct SyntheticPatient {
  CtVolume ct;
  LabelVolume structures;  // TotalSegmentator ids where it has one
  std::vector<Structure> structure_table;
  TissueVolume tissues;
  std::vector<Landmark> landmarks;  // names as build_patient gives them
  NeedlePath path;                  // planned lumbar puncture at L3/L4, midline
};

// The same parameters give the same voxels on every machine. HU and their noise come from `library`. Throws
// InputError naming the parameter, its value and its range.
SyntheticPatient synthesize_lumbar(const LumbarParameters& parameters, const TissueLibrary& library,
                                   const Progress& progress = {});

}  // namespace bodkin
