#pragma once

#include <concepts>
#include <string_view>

#include "anatomy/case.h"
#include "core/geometry.h"

namespace bodkin::forces {

// Where the needle is, as far as a constraint needs to know.
struct HeldNeedle {
  Vec3 tip = Vec3::Zero();           // LPS mm
  Vec3 axis = Vec3::UnitZ();         // unit, hub to tip
  double length = 0.0;               // mm, hub to tip
  bool resistance_holds_it = false;  // ResistanceTraits::holds_laterally
};

struct ConstraintTraits {
  std::string_view name;  // as cases, commands and sessions write it: "rail"
};

// A model of what keeps the needle on the line on which it touched the body, one file pair. Made as a resistance is
// (resistance_model.h); begin() freezes the line through `entry` along the unit `direction` with the tip at `tip`;
// step() gives force and torque about the tip, on the hand. Nothing in the tick allocates or throws.
template <typename Model>
concept ConstraintModel = std::same_as<decltype(Model::traits), const ConstraintTraits> &&
    std::constructible_from<Model, const anatomy::Case&, const typename Model::Settings&, double> &&
    requires(Model model, const HeldNeedle& needle, const Vec3& vector) {
  { model.begin(vector, vector, vector) }
  noexcept;
  { model.step(needle) }
  noexcept->std::same_as<Wrench>;
};

// A force at the hub, moved to the tip.
inline Wrench from_hub(const Vec3& force, const HeldNeedle& needle) noexcept {
  return {force, (-needle.length * needle.axis).cross(force)};
}

}  // namespace bodkin::forces
