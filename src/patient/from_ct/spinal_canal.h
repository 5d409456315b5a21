#pragma once

#include <optional>
#include <vector>

#include "patient/from_ct/spine_view.h"

namespace bodkin::patient {

// The spinal canal at one height.
struct CanalSection {
  double x = 0.0;            // LPS mm of the midline
  double front = 0.0;        // LPS y of the back of the vertebral bodies and discs
  double back = 0.0;         // LPS y of the front of the laminae, in the midline; > front
  double half_width = 11.0;  // mm
};

// The canal as one section a millimetre of height.
struct SpinalCanal {
  double lowest = 0.0;                 // LPS z of the first section
  std::vector<CanalSection> sections;  // 1 mm apart, upwards
  bool labelled = false;               // from a canal label, whose back may lie in front of the true wall

  double highest() const { return lowest + static_cast<double>(sections.size()) - 1.0; }
  bool covers(double z) const { return !sections.empty() && z >= lowest - 0.5 && z <= highest() + 0.5; }
  // Interpolated; clamped to the ends.
  CanalSection at(double z) const;
  // Cosine of the canal's slope to the vertical in the sagittal plane.
  double cosine(double z) const;
};

// From the voxels of a canal label. Empty if they span less than 15 mm.
std::optional<SpinalCanal> canal_from_label(const SpineView& view);

// From bone, along a midline (LPS x for each slice of the view): wherever a lamina lies behind and a vertebral body
// or disc in front of a gap of 9 to 27 mm, that gap is the canal; between laminae it is interpolated. Empty if fewer
// than `least` mm of laminae are found.
std::optional<SpinalCanal> canal_from_bone(const SpineView& view, const std::vector<double>& midline, double least);

// The gap behind a body and before a lamina in one sagittal row, LPS y.
struct CanalGap {
  double front, back;
  double lamina;  // mm of bone behind the gap, to the tip of the spinous process
};
std::optional<CanalGap> canal_gap(const SpineView& view, int i, int k);

// Moving average over +-`reach` entries; shorter at the ends.
std::vector<double> moving_average(const std::vector<double>& values, int reach);

}  // namespace bodkin::patient
