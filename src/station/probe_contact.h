#pragma once

#include "anatomy/volume.h"
#include "core/geometry.h"
#include "core/motion_estimator.h"

namespace bodkin::station {

// mm from the skin to `tip` along `axis` (unit, both LPS), 0 when the ray meets only air. The skin is where a ray
// from 40 mm before the tip first leaves the air: steps of 0.5 mm, then bisection. The eight voxels around a point,
// weighted trilinearly, decide whether it is in the body, so that the skin has no steps. Returns 40 mm for a ray that
// begins in the body. Allocates nothing.
double depth_below_skin(const anatomy::TissueVolume& tissues, const Vec3& tip, const Vec3& axis) noexcept;

// An ultrasound transducer on the skin, which yields along the transducer's axis.
//
//   F = k d + b d',  0 <= F <= 15 N,  d: depth_below_skin;  k = 0.4 N/mm, b = 0.002 N s/mm, or the device's limits
//
// There is no friction and no torque, and the skin does not move.
class ProbeContact {
 public:
  // `tissues` must outlive the object. `dt`: s of a tick, 0.00025 to 0.005. `resolution`: mm of one count of the
  // device. `stiffness`, `damping`: rendered stably by the device, N/mm and N s/mm.
  ProbeContact(const anatomy::TissueVolume& tissues, double dt, double resolution, double stiffness, double damping);

  // The force (N, LPS) on the hand that holds the transducer at `probe` (LPS, third axis out of its tip).
  Vec3 step(const Pose& probe) noexcept;

  double depth() const noexcept { return depth_; }  // mm, of the last step
  double force() const noexcept { return force_; }  // N out of the skin, along the axis

 private:
  const anatomy::TissueVolume& tissues_;
  double stiffness_, damping_;
  MotionEstimator motion_;
  double depth_ = 0.0;
  double force_ = 0.0;
};

// The pose of the machine's probe in the hand that holds `tool` (third axis out of its face, LPS): the tool's third
// axis is the probe's second, and both have the array along the first.
Pose probe_in_hand(const Pose& tool);

}  // namespace bodkin::station
