#pragma once

#include <string>
#include <vector>

#include "patient/from_ct/layer_search.h"
#include "patient/from_ct/level_landmarks.h"
#include "patient/from_ct/spinal_canal.h"
#include "patient/from_ct/vertebral_levels.h"

namespace bodkin::patient {

// A gap between two laminae in the midline.
struct Interspace {
  std::string name;                      // "L3_L4"; "interspace_1" (the lowest) where levels are unknown
  double low, high;                      // LPS z of the edges of the two laminae
  double flavum;                         // mm, thickness of its ligamentum flavum
  double bulge = 0.0;                    // mm by which the canal's wall lies behind `CanalSection::back`; may be < 0
  LayersSeen seen = {};                  // layers visible in the CT; the rest is textbook
  std::optional<SpinePlace> place = {};  // empty if levels are unknown
  bool cut = false;                      // the image border cuts one of its two vertebrae
  double middle() const { return 0.5 * (low + high); }
};

// The posterior elements of a lumbar spine along its canal. The vectors have one entry per section of the canal.
struct LumbarSpine {
  SpinalCanal canal;
  std::vector<double> tip;              // LPS y of the line along the tips of the spinous processes
  std::vector<double> tip_x;            // LPS x of the spinous processes
  std::vector<Interspace> interspaces;  // from head to foot; lumbar ones only (T12_L1 to L5_S1)
  VertebralLevels levels;               // of all interspaces found, also of those that are not lumbar
  SpinePlace conus_place = adult_conus;
  std::optional<double> conus;  // LPS z of the lower end of the cord; empty if levels are unknown
};

// Further evidence for the levels: the user's statement, and landmarks near the spine.
struct LevelTexts {
  LevelLandmarks landmarks;
  std::string lowest_vertebra;  // the vertebra above the lowest interspace, "L5"; empty = not stated
  SpinePlace conus = adult_conus;
  double voxel = 1.0;  // mm, the longest edge of a CT voxel
};

// Finds the interspaces and the spinous processes about `canal`, and names them by name_levels().
LumbarSpine find_interspaces(const SpineView& view, SpinalCanal canal, const LevelTexts& words = {});

// Marks the interspaces with a vertebra cut by the image border at head or foot: whose labelled vertebra reaches the
// border, or, without labels, which have less than 40 mm of image above or below their middle (25 mm below that of
// the sacrum, which may be cut lower down).
void mark_cut(LumbarSpine& spine, const anatomy::Grid& image, const anatomy::LabelVolume& structures,
              const std::vector<std::uint8_t>& roles);

}  // namespace bodkin::patient
