#pragma once

#include <memory>

#include "anatomy/case.h"
#include "core/geometry.h"
#include "forces/constraint_model.h"
#include "forces/rail.h"

namespace bodkin::simulation {

// The constraint chosen by a case. step() allocates nothing.
class Constraint {
 public:
  // Throws InputError when the settings make the model impossible or too stiff for the device.
  Constraint(const anatomy::Case& patient, double dt);

  // Freezes the line through `entry` along the unit `direction`; `tip`: present position.
  void begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept {
    if (model_ != nullptr) model_->begin(entry, direction, tip);
  }
  // Force and torque about the tip, on the hand. `torque_only`: the resistance has a lateral force of its own.
  Wrench step(const Vec3& tip, const Vec3& axis, bool torque_only) noexcept {
    if (model_ == nullptr) return {};
    return model_->step({.tip = tip, .axis = axis, .length = length_, .torque_only = torque_only});
  }
  // The rail, if that is the constraint; nullptr otherwise.
  const forces::Rail* rail() const noexcept { return model_ == nullptr ? nullptr : model_->rail(); }

 private:
  std::unique_ptr<forces::AnyConstraint> model_;  // none: the needle is free to leave its line
  double length_;                                 // mm, hub to tip
};

}  // namespace bodkin::simulation
