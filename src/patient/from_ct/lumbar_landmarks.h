#pragma once

#include <string>
#include <vector>

#include "patient/from_ct/spinal_canal.h"

namespace bodkin::patient {

// A gap between two laminae in the midline.
struct Interspace {
  std::string name;    // "L3_L4"; "interspace_1" (the lowest) where levels are unknown
  double low, high;    // LPS z of the edges of the two laminae
  double flavum;       // mm, thickness of its ligamentum flavum
  double bulge = 0.0;  // mm by which the wall of the canal stands back here behind `CanalSection::back`
  double middle() const { return 0.5 * (low + high); }
};

// The posterior elements of a lumbar spine along its canal. The vectors have one entry per section of the canal.
struct LumbarSpine {
  SpinalCanal canal;
  std::vector<double> tip;              // LPS y of the line along the tips of the spinous processes
  std::vector<double> tip_x;            // LPS x of the spinous processes
  std::vector<Interspace> interspaces;  // from head to foot; lumbar ones only (T12_L1 to L5_S1)
  bool levels_known = false;            // interspaces carry the names of vertebrae
  bool counted_from_sacrum = false;     // those names were counted, not read from labels
};

// Finds the interspaces and the spinous processes about `canal`. Levels are named by the labels of the vertebrae,
// else counted up from the sacrum (a dorsal plate of bone longer than 35 mm), else numbered from below.
LumbarSpine find_interspaces(const SpineView& view, SpinalCanal canal);

}  // namespace bodkin::patient
