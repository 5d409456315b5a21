#include "forces/spring_damper_wall.h"

#include <algorithm>

#include "forces/model_input.h"

namespace bodkin {

SpringDamperWall::SpringDamperWall(const SpringDamperWallSettings& settings) : settings_(settings) {
  constexpr auto model = "spring_damper_wall";
  check_setting(model, "stiffness", "N/mm", settings.stiffness, 0.0, 100.0);
  check_setting(model, "damping", "N s/mm", settings.damping, 0.0, 1.0);
  check_setting(model, "wall", "mm", settings.wall, -1000.0, 1000.0);
  check_setting(model, "limit", "N", settings.limit, 1e-3, 100.0);
}

double SpringDamperWall::step(const AxialMotion& motion, TissueId tissue, TickEvents& events) noexcept {
  if (!usable(motion)) {
    events.push({EventKind::fault, tissue, settings_.wall, 0.0});
    return 0.0;
  }
  if (motion.depth < settings_.wall) return 0.0;
  const double force = settings_.stiffness * (motion.depth - settings_.wall) + settings_.damping * motion.velocity;
  return std::clamp(force, 0.0, settings_.limit);  // eq. 2; a wall pushes, it never holds
}

}  // namespace bodkin
