#pragma once

#include <variant>

#include "anatomy/case.h"
#include "core/geometry.h"
#include "forces/beam.h"
#include "forces/line_spring.h"
#include "forces/pivot.h"
#include "forces/rail.h"

namespace bodkin {

// The constraint that a case chooses: any of `constraint_names`. Forces that a model applies at the hub (`pivot`,
// `beam`) are moved to the tip with the torque that this takes. step() allocates nothing.
class Constraint {
 public:
  // Throws InputError when the settings make the model impossible or too stiff for the device.
  Constraint(const Case& patient, double dt);

  // Freezes the line through `entry` along the unit `direction`; `tip`: where the needle is now.
  void begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept;
  // Force and torque about the tip, on the hand. `torque_only`: the resistance holds the needle laterally itself.
  Wrench step(const Vec3& tip, const Vec3& axis, bool torque_only) noexcept;
  // The rail, if that is the constraint; nullptr otherwise.
  const Rail* rail() const noexcept { return std::get_if<Rail>(&model_); }

 private:
  using Model = std::variant<LineSpring, Pivot, Rail, Beam, NoConstraint>;
  static Model make(const Case& patient, double dt);

  Model model_;
  double length_;  // mm, hub to tip
};

}  // namespace bodkin
