#pragma once

#include <optional>

#include "patient/from_ct/lumbar_landmarks.h"

#include "anatomy/volume.h"

namespace bodkin::patient {

// Thicknesses of structures invisible in CT, mm (reference/layer_thickness.csv).
namespace lumbar_size {
// Interspinous ligament, its width at the flavum, in the middle, and at the supraspinous ligament: Lawrence et al.,
// Anatomy of the lumbar interspinous ligament, medians of 73 interspaces.
inline constexpr double interspinous_front = 7.3, interspinous_middle = 4.5, interspinous_back = 9.2;
inline constexpr double supraspinous_depth = 5.0;  // band over the tips of the spinous processes
inline constexpr double epidural_depth = 6.0;      // posterior, in the midline of an interspace (IEEE 8794199)
inline constexpr double epidural_share = 0.36;     // of the canal's depth at most, in narrow canals
inline constexpr double epidural_under_lamina = 2.0, least_epidural = 1.5;
inline constexpr double lateral_epidural = 1.5, anterior_epidural = 1.0;
inline constexpr double dural_end = 45.0;  // below the middle of L5/S1, at S2
}  // namespace lumbar_size

// The middle of the dural sac at height z, LPS mm.
Vec3 sac_centre(const LumbarSpine& spine, double z);

// Draws supraspinous and interspinous ligaments, ligamentum flavum, epidural space, dura, cerebrospinal fluid, cord
// and cauda equina into `tissues`: the ligaments from the uppermost to the lowest interspace, the canal's contents
// along the whole canal. Bone, discs, skin and air are not changed, and fat does not become supraspinous ligament. A
// straight line from behind that meets no bone crosses flavum before epidural space, and every line to cerebrospinal
// fluid crosses dura: dura is every voxel of the sac that touches, even by a corner, a voxel outside the sac.
void draw_lumbar(anatomy::TissueVolume& tissues, const LumbarSpine& spine);

// Turns unclassified soft tissue behind the vertebral bodies, over the height of the canal, into muscle of the back.
void muscle_behind(anatomy::TissueVolume& tissues, const SpinalCanal& canal);

}  // namespace bodkin::patient
