#include "forces/shaft_friction.h"

#include <algorithm>

#include "forces/model_input.h"

namespace bodkin {

ShaftContact shaft_contact(std::span<const TissueId> layers, double layer, double depth,
                           const std::array<ShaftFrictionTissue, 256>& tissues) noexcept {
  ShaftContact sum;
  if (!(layer > 0.0) || !(depth > 0.0)) return sum;
  double left = depth;
  for (const TissueId id : layers) {
    if (left <= 0.0) break;
    const ShaftFrictionTissue& here = tissues[id];
    const double length = std::min(left, layer);
    sum.coulomb += here.coulomb * length;
    sum.static_force += here.static_force * length;
    if (here.coulomb > 0.0) sum.stiffness += here.stiffness * length;  // what cannot hold cannot stretch either
    sum.viscous += here.viscous * length;
    left -= layer;
  }
  return sum;
}

ShaftFriction::ShaftFriction(const ShaftFrictionSettings& settings) : stribeck_velocity_(settings.stribeck_velocity) {
  check_setting("shaft_friction", "Stribeck velocity", "mm/s", settings.stribeck_velocity, 0.01, 1000.0);
}

double ShaftFriction::step(const AxialMotion& motion, const ShaftContact& contact, TickEvents& events) noexcept {
  if (!usable(motion)) {
    events.push({EventKind::fault, tissue::air, last_depth_, 0.0});
    return 0.0;
  }
  if (fresh_) {
    fresh_ = false;
    stretch_ = 0.0;
    last_depth_ = motion.depth;
  }
  const double dx = motion.depth - last_depth_;
  last_depth_ = motion.depth;
  const double g = stribeck(contact, motion.velocity, stribeck_velocity_);
  if (!(g > 0.0) || !(contact.stiffness > 0.0)) {  // no contact
    stretch_ = 0.0;
    return contact.viscous > 0.0 ? contact.viscous * motion.velocity : 0.0;
  }
  if (dx != 0.0) {
    const double steady = std::copysign(g / contact.stiffness, dx);  // z_ss
    stretch_ = steady + (stretch_ - steady) * std::exp(-contact.stiffness * std::abs(dx) / g);
  }
  return contact.stiffness * stretch_ + contact.viscous * motion.velocity;
}

}  // namespace bodkin
