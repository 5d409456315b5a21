#pragma once

#include <array>
#include <vector>

#include "anatomy/force_settings.h"
#include "anatomy/tissue.h"
#include "anatomy/volume.h"

namespace bodkin::forces {

// The field and its slope at a point.
struct FieldSample {
  double value = 0.0;            // V
  Vec3 gradient = Vec3::Zero();  // LPS, 1/mm
  bool inside = false;           // false: the point is outside the volume, the rest is zero
};

// The scalar field that haptic volume rendering follows: V = V_label + V_CT (Faerber, Heller, Handels,
// section 2.1.3), on the lattice of the tissues. Labels have infinite gradients, so V_label is smoothed first. The
// gradient is that of central differences, trilinear between voxels; it is as continuous as the value.
class HapticField {
 public:
  // Throws InputError for settings out of range or an empty volume. Needs 4 bytes per voxel and a second or two for a
  // large patient. `tissues` must outlive the field.
  HapticField(const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
              const anatomy::TissueLibrary& library, const anatomy::HapticFieldSettings& settings);

  // Never throws; NaN is outside.
  FieldSample sample(const Vec3& point) const noexcept;
  // Air outside.
  anatomy::TissueId tissue(const Vec3& point) const noexcept {
    return anatomy::nearest(*tissues_, point, anatomy::tissue::air);
  }

 private:
  void smooth(double sigma);

  const anatomy::TissueVolume* tissues_;
  Mat3 to_index_;              // LPS mm from the origin -> continuous index
  Mat3 to_patient_gradient_;   // per voxel -> per mm, LPS
  std::vector<float> values_;  // V, grid.voxel_count(), i fastest
};

}  // namespace bodkin::forces
