#pragma once

#include <concepts>
#include <memory>
#include <type_traits>

#include "anatomy/case.h"
#include "core/geometry.h"

namespace bodkin::forces {

class Rail;

// The needle's pose, as a constraint needs it.
struct ConstraintInput {
  Vec3 tip = Vec3::Zero();    // LPS mm
  Vec3 axis = Vec3::UnitZ();  // unit, hub to tip
  double length = 0.0;        // mm, hub to tip
  bool torque_only = false;   // ResistanceTraits::has_lateral_force
};

// A model of the forces that keep the needle on the line on which it touched the body, one file pair. Constructed
// like a resistance (resistance_model.h). begin() freezes the line through `entry` along the unit `direction` with
// the tip at `tip`; step() returns force and torque about the tip, on the hand. Nothing in the tick allocates or
// throws.
template <typename Model>
concept ConstraintModel =
    std::constructible_from<Model, const anatomy::Case&, const typename Model::Settings&, double> &&
    requires(Model model, const ConstraintInput& needle, const Vec3& vector) {
  { model.begin(vector, vector, vector) }
  noexcept;
  { model.step(needle) }
  noexcept->std::same_as<Wrench>;
};

// A force at the hub, moved to the tip.
inline Wrench from_hub(const Vec3& force, const ConstraintInput& needle) noexcept {
  return {force, (-needle.length * needle.axis).cross(force)};
}

// Any constraint model behind one interface.
class AnyConstraint {
 public:
  virtual ~AnyConstraint() = default;
  virtual void begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept = 0;
  virtual Wrench step(const ConstraintInput& needle) noexcept = 0;
  // The rail, if that is the constraint; nullptr otherwise.
  virtual const Rail* rail() const noexcept = 0;
};

template <ConstraintModel Model>
class ConstraintOf final : public AnyConstraint {
 public:
  ConstraintOf(const anatomy::Case& patient, const typename Model::Settings& settings, double dt)
      : model_(patient, settings, dt) {}

  void begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept override {
    model_.begin(entry, direction, tip);
  }
  Wrench step(const ConstraintInput& needle) noexcept override { return model_.step(needle); }
  const Rail* rail() const noexcept override {
    if constexpr (std::is_same_v<Model, Rail>) return &model_;
    return nullptr;
  }

 private:
  Model model_;
};

// The constraint with these settings, one of anatomy::ConstraintSettings. The source of the model defines it, or the
// program does not link. Throws InputError as the model's constructor does.
template <typename Settings>
std::unique_ptr<AnyConstraint> constraint_with(const anatomy::Case& patient, const Settings& settings, double dt);

}  // namespace bodkin::forces
