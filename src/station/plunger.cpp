#include "station/plunger.h"

#include <algorithm>
#include <numbers>

namespace bodkin::station {

namespace {

constexpr double stop_stiffness = 1.0;      // N/mm
constexpr double guide_stiffness = 0.2;     // N/mm
constexpr double most_guide_force = 1.0;    // N
constexpr double largest_compliance = 1e5;  // mm^3/MPa, for a syringe
constexpr double friction_eases_at = 1.0;   // mm/s, see forces/syringe.cpp

anatomy::SyringeSettings settings_for(double stiffness, double damping) {
  anatomy::SyringeSettings settings;
  const double area = std::numbers::pi * settings.bore * settings.bore / 4.0;
  settings.saline_compliance = std::clamp(area * area / stiffness, settings.saline_compliance, largest_compliance);
  settings.friction = std::min(settings.friction, damping * friction_eases_at);
  return settings;
}

}  // namespace

Plunger::Plunger(const anatomy::TissueLibrary& library, double dt, double stiffness, double damping)
    : dt_(dt),
      stiffness_(std::min(stop_stiffness, stiffness)),
      syringe_(library, settings_for(stiffness_, damping), dt) {}

Vec3 Plunger::step(const Vec3& hand, anatomy::TissueId tissue, bool armed) noexcept {
  if (!armed) {
    start_ = hand;
    travel_ = force_ = 0.0;
    syringe_.reset();
    return Vec3::Zero();
  }
  const double inwards = start_.z() - hand.z();
  const double travel = std::clamp(inwards, 0.0, barrel_length);
  const forces::SyringeState& state = syringe_.step((travel - travel_) / dt_, tissue);
  travel_ = travel;
  force_ = inwards > 0.0 ? state.force + stiffness_ * std::max(0.0, inwards - barrel_length) : 0.0;
  Vec3 guide = guide_stiffness * (start_ - hand);
  guide.z() = 0.0;
  const double size = guide.norm();
  if (size > most_guide_force) guide *= most_guide_force / size;
  return guide + force_ * Vec3::UnitZ();
}

}  // namespace bodkin::station
