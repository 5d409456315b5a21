#pragma once

#include <memory>

#include "anatomy/case.h"
#include "fem/closest_node.h"
#include "fem/embedded_needle.h"
#include "simulation/bone_wall.h"
#include "simulation/resistance.h"

namespace bodkin {

// The resistances of a deformable body (docs/fem-contact.md) in the tick. The patient must have a body and outlive
// them; its library says what a needle meets in each tissue. Throw InputError when there is no body, or for settings
// or tissues out of range.

// `embedded_needle`: all nodes along the shaft. Where these are stiffer along the planned path than the device can
// render, the hand feels the body through a spring, which leaves stiffness_scale() of that stiffness and every force.
class DeformableShaft {
 public:
  DeformableShaft(const Case& patient, const EmbeddedNeedleSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  void reset() noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  double stiffness_scale() const noexcept { return scale_; }

 private:
  double scale_ = 1.0;
  std::shared_ptr<const CondensedBody> body_;
  std::unique_ptr<EmbeddedNeedle> needle_;  // refers to the body
  BoneWall bone_;
  Vec3 direction_ = Vec3::UnitZ();
  bool beyond_ = false;  // the needle has left the corridor
};

// `closest_node`: the paper's scheme, one node at the tip. Tissues that are stiffer than the device can render are as
// stiff as it can; stiffness_scale() tells by how much.
class DeformableTip {
 public:
  DeformableTip(const Case& patient, const ClosestNodeSettings& settings, double dt);

  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  void reset() noexcept;
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  double stiffness_scale() const noexcept { return scale_; }

 private:
  double scale_ = 1.0;
  BoneWall bone_;
  std::unique_ptr<ClosestNodeContact> contact_;
  Vec3 direction_ = Vec3::UnitZ();
};

}  // namespace bodkin
