#include "simulation/constraint.h"

#include "simulation/device_stability.h"

namespace bodkin {

Constraint::Model Constraint::make(const Case& patient, double dt) {
  struct Maker {
    const Case& patient;
    double dt;
    const DeviceLimits& device() const { return patient.description.device; }

    Model operator()(const LineSpringSettings& settings) const {
      return LineSpring(settings, device().stiffness, dt);
    }
    Model operator()(const PivotSettings& settings) const {
      return Pivot(settings, patient.description.needle.length);
    }
    Model operator()(const RailSettings& settings) const {
      require_stable("rail", "stiffness", settings.stiffness, device());
      return Rail(settings);
    }
    Model operator()(const BeamSettings& settings) const {
      require_stable("beam", "largest stiffness", settings.largest_stiffness, device());
      return Beam(settings, patient.description.needle, dt);
    }
    Model operator()(const NoConstraint&) const { return NoConstraint{}; }
  };
  return std::visit(Maker{patient, dt}, patient.description.haptics.constraint);
}

Constraint::Constraint(const Case& patient, double dt)
    : model_(make(patient, dt)), length_(patient.description.needle.length) {}

void Constraint::begin(const Vec3& entry, const Vec3& direction, const Vec3& tip) noexcept {
  if (auto* spring = std::get_if<LineSpring>(&model_)) {
    spring->begin(entry, direction);
  } else if (auto* pivot = std::get_if<Pivot>(&model_)) {
    pivot->begin(entry, direction);
  } else if (auto* rail = std::get_if<Rail>(&model_)) {
    rail->begin(entry, direction);
  } else if (auto* beam = std::get_if<Beam>(&model_)) {
    beam->begin(entry, direction, tip);
  }
}

Wrench Constraint::step(const Vec3& tip, const Vec3& axis, bool torque_only) noexcept {
  const auto at_hub = [&](const Vec3& force) { return Wrench{force, (-length_ * axis).cross(force)}; };
  if (auto* spring = std::get_if<LineSpring>(&model_)) return {spring->step(tip), Vec3::Zero()};
  if (const auto* pivot = std::get_if<Pivot>(&model_)) return at_hub(pivot->step(tip, axis));
  if (auto* beam = std::get_if<Beam>(&model_)) return at_hub(beam->step(tip, axis));
  if (const auto* rail = std::get_if<Rail>(&model_)) {
    Wrench wrench = rail->step(tip, axis);
    if (torque_only) wrench.force.setZero();
    return wrench;
  }
  return {};
}

}  // namespace bodkin
