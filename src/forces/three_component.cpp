#include "forces/three_component.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "forces/device_stability.h"
#include "forces/model_input.h"

namespace bodkin {

ThreeComponent::ThreeComponent(const ThreeComponentSettings& settings)
    : settings_(settings), edge_(settings.cutting_force, settings.cutting_stiffness) {
  constexpr auto model = "three_component";
  check_setting(model, "linear stiffness a1", "N/mm", settings.linear, 0.0, 10.0);
  check_setting(model, "quadratic stiffness a2", "N/mm^2", settings.quadratic, 0.0, 10.0);
  if (settings.linear == 0.0 && settings.quadratic == 0.0) {
    throw InputError(
        "three_component: a1 and a2 are both 0, so nothing ever breaks; give one of them a positive value");
  }
  check_setting(model, "puncture force", "N", settings.puncture_force, 0.01, 50.0);
  check_setting(model, "cutting force", "N", settings.cutting_force, 0.0, settings.puncture_force);
  check_setting(model, "cutting stiffness", "N/mm", settings.cutting_stiffness, 0.01, 100.0);
  for (const KarnoppFriction& one : {settings.inwards, settings.outwards}) {
    check_setting(model, "Coulomb friction", "N/mm", one.coulomb, 0.0, 10.0);
    check_setting(model, "viscous friction", "N s/mm^2", one.viscous, 0.0, 1.0);
    check_setting(model, "static friction", "N/mm", one.static_force, 0.0, 10.0);
  }
  check_setting(model, "dead band", "mm/s", settings.dead_band, 0.01, 100.0);
  check_setting(model, "holding spring", "N/mm^2", settings.hold, 0.001, 100.0);
  check_setting(model, "limit", "N", settings.limit, 1e-3, 100.0);
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
  const KarnoppFriction& side = inwards ? settings_.inwards : settings_.outwards;
  const bool sliding = std::abs(motion.velocity) >= 0.5 * settings_.dead_band;
  const double most = sliding ? side.coulomb : side.static_force;
  if (dx != 0.0) {
    const double steady = std::copysign(most / settings_.hold, dx);
    const double faded = most > 0.0 ? std::exp(-settings_.hold * std::abs(dx) / most) : 0.0;
    stretch_ = steady + (stretch_ - steady) * faded;
  }
  return motion.depth * (settings_.hold * stretch_ + (sliding ? side.viscous * motion.velocity : 0.0));
}

double ThreeComponent::step(const AxialMotion& motion, TissueId tissue, TickEvents& events) noexcept {
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

ThreeComponent::ThreeComponent(const Case& patient, const ThreeComponentSettings& settings, double)
    : ThreeComponent(settings) {
  const DeviceLimits& device = patient.description.device;
  require_stable("three_component", "cutting stiffness", settings.cutting_stiffness, device);
  // R = a1 x + a2 x^2 has its steepest slope where it breaks: dR/dx = sqrt(a1^2 + 4 a2 R).
  require_stable("three_component", "the stiffness at which the capsule gives way",
                 std::sqrt(settings.linear * settings.linear + 4.0 * settings.quadratic * settings.puncture_force),
                 device);
}

ResistanceForce ThreeComponent::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const double force = step(needle.motion, needle.tissue, events);
  return {.along = force, .in_contact = needle.motion.depth > 0.0};
}

}  // namespace bodkin
