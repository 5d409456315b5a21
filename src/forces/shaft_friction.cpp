#include "forces/shaft_friction.h"

#include <algorithm>
#include <string>

#include "core/repeatable.h"
#include "forces/model_input.h"
#include "forces/needle_law.h"

namespace bodkin::forces {

namespace {

constexpr double path_layer = 0.5;        // mm between tissue samples along the line
constexpr double longest_shaft = 400.0;   // mm; greater depths count as 400 mm
constexpr double least_hold_share = 0.1;  // of the device's stiffness, reserved for the friction's spring

}  // namespace

ShaftContact shaft_contact(std::span<const anatomy::TissueId> layers, double layer, double depth,
                           const std::array<anatomy::ShaftFrictionTissue, 256>& tissues) noexcept {
  ShaftContact sum;
  if (!(layer > 0.0) || !(depth > 0.0)) return sum;
  double left = depth;
  for (const anatomy::TissueId id : layers) {
    if (left <= 0.0) break;
    const anatomy::ShaftFrictionTissue& here = tissues[id];
    const double length = std::min(left, layer);
    sum.coulomb += here.coulomb * length;
    sum.static_force += here.static_force * length;
    if (here.coulomb > 0.0) sum.stiffness += here.stiffness * length;  // without friction there is no stretch
    sum.viscous += here.viscous * length;
    left -= layer;
  }
  return sum;
}

ShaftFriction::ShaftFriction(const anatomy::ShaftFrictionSettings& settings)
    : stribeck_velocity_(settings.stribeck_velocity) {
  check(settings, "shaft_friction");
}

double ShaftFriction::step(const AxialMotion& motion, const ShaftContact& contact, TickEvents& events) noexcept {
  if (!usable(motion)) {
    events.push({EventKind::fault, anatomy::tissue::air, last_depth_, 0.0});
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
    stretch_ = steady + (stretch_ - steady) * repeatable::exp(-contact.stiffness * std::abs(dx) / g);
  }
  return contact.stiffness * stretch_ + contact.viscous * motion.velocity;
}

ShaftFrictionResistance::ShaftFrictionResistance(const anatomy::Case& patient,
                                                 const anatomy::ShaftFrictionSettings& settings, double, double firm)
    : model_(settings),
      tissues_(effective_tissues(patient).by_id(&anatomy::TissueProperties::shaft_friction)),
      path_(path_layer, longest_shaft),
      volume_(&patient.tissues),
      budget_(std::max(patient.description.device.stiffness - firm,
                       least_hold_share * patient.description.device.stiffness)) {
  check_tissues(effective_tissues(patient), &anatomy::TissueProperties::shaft_friction, "shaft_friction");
}

void ShaftFrictionResistance::begin(const Vec3& entry, const Vec3& direction) noexcept {
  path_.restart(entry, direction);
  model_.begin();
}

ResistanceForce ShaftFrictionResistance::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const double depth = std::min(needle.motion.depth, longest_shaft);
  path_.extend_to(depth, *volume_);
  ShaftContact contact = shaft_contact(path_.layers(), path_layer, depth, tissues_);
  contact.coulomb *= needle.grip;
  contact.static_force *= needle.grip;
  // A long shaft stretches tissue over a longer distance.
  contact.stiffness = std::min(contact.stiffness * needle.grip, budget_);
  return {.along = model_.step(needle.motion, contact, events), .in_contact = needle.motion.depth > 0.0};
}

template <>
ResistanceEntry resistance_with<anatomy::ShaftFrictionSettings>() {
  return entry_of<ShaftFrictionResistance>();
}

}  // namespace bodkin::forces
