#include "forces/three_component.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/repeatable.h"
#include "forces/device_stability.h"
#include "forces/model_input.h"
#include "forces/needle_law.h"

namespace bodkin::forces {

ThreeComponent::ThreeComponent(const anatomy::ThreeComponentSettings& settings)
    : settings_(settings), edge_(settings.cutting_force, settings.cutting_stiffness) {
  check(settings, "three_component");
}

void ThreeComponent::begin(const Vec3& entry, const Vec3& direction) noexcept {
  channels_.enter(entry, direction);
  inside_ = false;
}

void ThreeComponent::reset() noexcept {
  channels_.clear();
  inside_ = false;
}

double ThreeComponent::friction(const AxialMotion& motion) noexcept {
  const double dx = motion.depth - last_depth_;
  const bool inwards = dx != 0.0 ? dx > 0.0 : motion.velocity > 0.0;
  const anatomy::KarnoppFriction& side = inwards ? settings_.inwards : settings_.outwards;
  const bool sliding = std::abs(motion.velocity) >= 0.5 * settings_.dead_band;
  const double most = sliding ? side.coulomb : side.static_force;
  if (dx != 0.0) {
    const double steady = std::copysign(most / settings_.hold, dx);
    const double faded = most > 0.0 ? repeatable::exp(-settings_.hold * std::abs(dx) / most) : 0.0;
    stretch_ = steady + (stretch_ - steady) * faded;
  }
  return motion.depth * (settings_.hold * stretch_ + (sliding ? side.viscous * motion.velocity : 0.0));
}

double ThreeComponent::step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept {
  const double x = motion.depth;
  cutting_ = friction_ = 0.0;
  if (!usable(motion)) {
    events.push({EventKind::fault, tissue, last_depth_, 0.0});
    return 0.0;
  }
  if (x <= 0.0) {
    if (inside_) events.push({EventKind::withdrawn, tissue, x, 0.0});
    inside_ = false;
    return 0.0;
  }
  if (!inside_) {
    events.push({EventKind::contact, tissue, x, 0.0});
    inside_ = true;
    punctured_ = channels_.deepest() > 0.0;
    edge_.start(channels_.deepest());
    stretch_ = 0.0;
    last_depth_ = x;
  }
  if (!punctured_) {
    const double force = settings_.linear * x + settings_.quadratic * x * x;
    if (force < settings_.puncture_force) return std::min(force, settings_.limit);
    events.push({EventKind::puncture, tissue, x, force});
    punctured_ = true;
    edge_.start(x - edge_.reach());
    stretch_ = 0.0;
    last_depth_ = x;
  }
  cutting_ = edge_.step(x);
  friction_ = friction(motion);
  const double force = cutting_ + friction_;
  channels_.deepen(edge_.wall());
  last_depth_ = x;
  return std::clamp(force, -settings_.limit, settings_.limit);
}

ThreeComponent::ThreeComponent(const anatomy::Case& patient, const anatomy::ThreeComponentSettings& settings, double)
    : ThreeComponent(felt_settings(settings, patient)) {
  const anatomy::DeviceLimits& device = patient.description.device;
  is_skin_ = patient.description.haptics.mechanics == anatomy::Mechanics::physical;
  require_stable("three_component", "cutting stiffness", settings_.cutting_stiffness, device);
  // R = a1 x + a2 x^2 has its steepest slope where it breaks: dR/dx = sqrt(a1^2 + 4 a2 R).
  require_stable(
      "three_component", "the stiffness at which the capsule gives way",
      std::sqrt(settings_.linear * settings_.linear + 4.0 * settings_.quadratic * settings_.puncture_force), device);
}

ResistanceForce ThreeComponent::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const double force = step(needle.motion, is_skin_ ? anatomy::tissue::skin : needle.tissue, events);
  return {.along = force, .material = punctured_ ? edge_.wall() : 0.0, .in_contact = needle.motion.depth > 0.0};
}

template <>
ResistanceEntry resistance_with<anatomy::ThreeComponentSettings>() {
  return entry_of<ThreeComponent>();
}

}  // namespace bodkin::forces
