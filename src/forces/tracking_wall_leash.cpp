#include "forces/tracking_wall_leash.h"

#include <algorithm>

#include "forces/model_input.h"
#include "forces/needle_law.h"

namespace bodkin::forces {

TrackingWallLeash::TrackingWallLeash(const anatomy::TissueLibrary& library,
                                     const anatomy::TrackingWallSettings& settings, double dt, double resolution)
    : settings_(settings),
      tissues_(library.by_id(&anatomy::TissueProperties::tracking_wall)),
      dt_(dt),
      clock_(resolution, dt),
      firm_stiffness_(stiffest_wall(library)) {
  check_tracking_wall(library, settings, "tracking_wall (leash)");
  check_tick("tracking_wall (leash)", dt);
}

void TrackingWallLeash::begin(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = wall_ = entry;
  direction_ = direction;
  stiffness_ = deepest_ = 0.0;
  inside_ = free_ = stopped_ = false;
}

void TrackingWallLeash::reset() noexcept {
  begin(Vec3::Zero(), Vec3::UnitZ());
}

const anatomy::TrackingWallTissue& TrackingWallLeash::layer_at(double depth,
                                                               anatomy::TissueId tissue) const noexcept {
  if (settings_.layers.empty()) return tissues_[tissue];
  std::size_t i = settings_.layers.size() - 1;
  while (i > 0 && depth < settings_.layers[i].from) --i;
  return settings_.layers[i].layer;
}

Vec3 TrackingWallLeash::step(const Vec3& tip, const AxialMotion& motion, anatomy::TissueId tissue,
                             TickEvents& events) noexcept {
  const double x = (tip - entry_).dot(direction_);
  if (!usable(motion) || !((tip - entry_).norm() <= farthest_depth)) {
    events.push({EventKind::fault, tissue, deepest_, 0.0});
    return Vec3::Zero();
  }
  const bool rests = clock_.step(x, motion.stopped || motion.direction == 0);
  if (x <= 0.0) {
    if (inside_) events.push({EventKind::withdrawn, tissue, x, 0.0});
    inside_ = stopped_ = false;
    free_ = deepest_ > 0.0;
    wall_ = entry_;
    stiffness_ = 0.0;
    return Vec3::Zero();
  }
  if (!inside_) events.push({EventKind::contact, tissue, x, 0.0});
  inside_ = true;
  if (free_ && x <= deepest_) {
    wall_ = tip;
    return Vec3::Zero();
  }
  free_ = false;
  deepest_ = std::max(deepest_, x);

  const anatomy::TrackingWallTissue layer = layer_at(x, tissue);
  if (stiffness_ > 0.0 && layer.stiffness != stiffness_) {
    wall_ = tip - stiffness_ / layer.stiffness * (tip - wall_);  // same force before and after
    stopped_ = false;
  }
  stiffness_ = layer.stiffness;

  if (rests) {
    if (!stopped_) {
      stop_wall_ = wall_;
      stop_tip_ = tip;
      clock_.start();
    }
    stopped_ = true;
    wall_ = stop_wall_ + (stop_tip_ - stop_wall_) * std::min(1.0, clock_.advance() * dt_ / settings_.catch_up);
  } else {
    stopped_ = false;
  }
  const double longest = layer.force / layer.stiffness;
  Vec3 leash = tip - wall_;
  if (const double length = leash.norm(); length > longest) {
    leash *= longest / length;
    wall_ = tip - leash;
  }
  if (leash.dot(direction_) <= 0.0 && motion.direction < 0) {
    free_ = true;
    wall_ = tip;
    return Vec3::Zero();
  }
  const Vec3 force = -layer.stiffness * leash;
  const double size = force.norm();
  return size > settings_.limit ? Vec3(force * (settings_.limit / size)) : force;
}

TrackingWallLeash::TrackingWallLeash(const anatomy::Case& patient, const anatomy::TrackingWallSettings& settings,
                                     double dt)
    : TrackingWallLeash(effective_tissues(patient), settings, dt, patient.description.device.position_resolution) {
  require_stable_walls(patient, settings);
}

ResistanceForce TrackingWallLeash::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const Vec3 force = step(needle.tip, needle.motion, needle.tissue, events);
  const double along = -force.dot(direction_);
  return {.along = along,
          .across = force + along * direction_,
          .material = (wall_ - entry_).dot(direction_),
          .in_contact = needle.motion.depth > 0.0};
}

// One name for two models: the wall stays on the line, or may leave it.
template <>
ResistanceEntry resistance_with<anatomy::TrackingWallSettings>() {
  return {TrackingWall::traits, [](const anatomy::Case& patient, double dt) {
            const auto& settings = std::get<anatomy::TrackingWallSettings>(patient.description.haptics.resistance);
            return (settings.leash ? entry_of<TrackingWallLeash>() : entry_of<TrackingWall>()).make(patient, dt);
          }};
}

}  // namespace bodkin::forces
