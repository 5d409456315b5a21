#pragma once

#include <array>

#include "patient/synthetic/lumbar.h"

namespace bodkin::patient {

// Positions of the vertebrae in the arrays below. T11 only shapes the curves above the volume.
namespace level {
inline constexpr int t11 = 0, t12 = 1, l1 = 2, l3 = 4, l4 = 5, l5 = 6, s1 = 7;
inline constexpr int vertebrae = 7;  // T11 to L5; the sacrum is a shape of its own
}  // namespace level

// Sizes of one vertebra, mm, rad. "Canal depth" is antero-posterior.
struct VertebraSize {
  double endplate_width, endplate_depth;
  double posterior_height, wedge;  // rad, > 0: the body is higher in front
  double canal_width, canal_depth;
  double pedicle_width, pedicle_height;
  double lamina_height;
  double process_reach;                       // from the back of the canal to the tip of the spinous process
  double process_height, process_tip_height;  // of the spinous process: middle, tip
  double process_drop;                        // by which its tip is lower than its base
  double transverse_span;                     // tip to tip of the transverse (costal) processes
  double facet_half_distance;                 // midline to the centre of the upper facet joint
  double facet_angle;                         // rad, of the upper facet joint to the sagittal plane
  double height() const;                      // middle of the body
};

// The structures between a vertebra and the next one below.
struct InterspaceSize {
  double disc_height;
  double disc_wedge;  // rad, > 0: higher in front (lordosis); flexion already subtracted
  double flavum_thickness;
  bool ligament_gap;  // a fat-filled gap in the interspinous ligament
};

struct SpineSizes {
  std::array<VertebraSize, level::vertebrae> vertebra;
  std::array<InterspaceSize, level::vertebrae> below;  // [i]: between vertebra i and i + 1 (the last: L5/S1)
  double sacrum_width, sacrum_depth;                   // upper endplate of S1
  double sacral_canal_width, sacral_canal_depth;
  double sacral_facet_half_distance, sacral_facet_angle;
  double facet_scale;  // enlargement of the articular processes with age
  double osteophyte;   // rim on the endplates, fraction of the half width
  double scoliosis;    // mm, sideways bow of the spine
  double rotation;     // rad, axial rotation at the apex of the bow
  double cobb;         // rad, of a requested curve, > 0: convex to the left
};

struct TorsoSizes {
  double scale;             // of everything that grows with body height
  double back_fat_midline;  // over the supraspinous ligament
  double back_fat;          // over the erector spinae
  double flank_fat, belly_fat;
  double visceral;  // fraction added to the abdominal cavity
  double skin;
  double muscle_fat;  // 0..1, fatty change of the back muscles with age
};

struct LumbarSizes {
  SpineSizes spine;
  TorsoSizes torso;
  double calcification;      // 0..1, see LumbarParameters
  double cancellous_factor;  // of the library's HU, falling with age
  double cortical_factor;
};

// Throws InputError naming the parameter, its value and its range.
void check_parameters(const LumbarParameters& parameters);

// Sizes for checked parameters: tables of morphometry, scaled by height, changed by age, weight and flexion, each
// varied by a few percent from the seed.
LumbarSizes lumbar_sizes(const LumbarParameters& parameters);

}  // namespace bodkin::patient
