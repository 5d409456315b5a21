#include "forces/spring_damper_wall.h"

#include <algorithm>

#include "forces/device_stability.h"
#include "forces/model_input.h"

namespace bodkin::forces {

SpringDamperWall::SpringDamperWall(const anatomy::SpringDamperWallSettings& settings) : settings_(settings) {
  check(settings, "spring_damper_wall");
}

double SpringDamperWall::step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept {
  if (!usable(motion)) {
    events.push({EventKind::fault, tissue, settings_.wall, 0.0});
    return 0.0;
  }
  if (motion.depth < settings_.wall) return 0.0;
  const double force = settings_.stiffness * (motion.depth - settings_.wall) + settings_.damping * motion.velocity;
  return std::clamp(force, 0.0, settings_.limit);  // eq. 2; a wall pushes and never pulls
}

SpringDamperWall::SpringDamperWall(const anatomy::Case& patient, const anatomy::SpringDamperWallSettings& settings,
                                   double dt)
    : SpringDamperWall(settings) {
  const anatomy::DeviceLimits& device = patient.description.device;
  require_stable("spring_damper_wall", "stiffness", settings.stiffness, device);
  require_stable_damping("spring_damper_wall", settings.stiffness, settings.damping, device, dt);
}

ResistanceForce SpringDamperWall::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const double force = step(needle.motion, needle.tissue, events);
  penetration_ = std::max(0.0, needle.motion.depth - settings_.wall);
  return {.along = force,
          .stiffness = force > 0.0 ? settings_.stiffness : 0.0,
          .material = settings_.wall,
          .in_contact = needle.motion.depth > 0.0};
}

template <>
ResistanceEntry resistance_with<anatomy::SpringDamperWallSettings>() {
  return entry_of<SpringDamperWall>();
}

}  // namespace bodkin::forces
