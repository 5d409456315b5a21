#pragma once

#include <memory>

#include "anatomy/case.h"
#include "core/geometry.h"
#include "forces/constraint_model.h"
#include "forces/rail.h"

namespace bodkin::simulation {

// Any constraint model behind one interface.
class AnyConstraint {
 public:
  virtual ~AnyConstraint() = default;
  virtual void begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept = 0;
  virtual Wrench step(const forces::HeldNeedle& needle) noexcept = 0;
  virtual const forces::Rail* rail() const noexcept = 0;
};

// The constraint that a case chooses; constraint.cpp lists them. step() allocates nothing.
class Constraint {
 public:
  // Throws InputError when the settings make the model impossible or too stiff for the device.
  Constraint(const anatomy::Case& patient, double dt);

  // Freezes the line through `entry` along the unit `direction`; `tip`: where the needle is now.
  void begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept {
    model_->begin(entry, direction, tip);
  }
  // Force and torque about the tip, on the hand. `torque_only`: the resistance holds the needle laterally itself.
  Wrench step(const Vec3& tip, const Vec3& axis, bool torque_only) noexcept {
    return model_->step({.tip = tip, .axis = axis, .length = length_, .resistance_holds_it = torque_only});
  }
  // The rail, if that is the constraint; nullptr otherwise.
  const forces::Rail* rail() const noexcept { return model_->rail(); }

 private:
  std::unique_ptr<AnyConstraint> model_;
  double length_;  // mm, hub to tip
};

}  // namespace bodkin::simulation
