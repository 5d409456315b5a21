#include "forces/tracking_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.h"
#include "forces/device_stability.h"
#include "forces/model_input.h"
#include "forces/needle_law.h"

namespace bodkin::forces {

void check_tracking_wall(const anatomy::TissueLibrary& library, const anatomy::TrackingWallSettings& settings,
                         const char* model) {
  check(settings, model);
  check_tissues(library, &anatomy::TissueProperties::tracking_wall, model);
}

TrackingWall::TrackingWall(const anatomy::TissueLibrary& library, const anatomy::TrackingWallSettings& settings,
                           double dt, double resolution)
    : settings_(settings),
      tissues_(library.by_id(&anatomy::TissueProperties::tracking_wall)),
      dt_(dt),
      channels_(settings.channel_radius, settings.channel_tilt),
      clock_(resolution, dt),
      firm_stiffness_(stiffest_wall(library)) {
  check_tracking_wall(library, settings, "tracking_wall");
  check_tick("tracking_wall", dt);
  reset();
}

void TrackingWall::reset() noexcept {
  channels_.clear();
  mode_ = Mode::outside;
  wall_ = stop_wall_ = stop_depth_ = last_stop_ = settings_.surface;
  stiffness_ = 0.0;
}

void TrackingWall::begin(const Vec3& entry, const Vec3& direction) noexcept {
  if (channels_.enter(entry, direction)) last_stop_ = settings_.surface;
  mode_ = Mode::outside;
  wall_ = settings_.surface;
}

const anatomy::TrackingWallTissue& TrackingWall::layer_at(double depth, anatomy::TissueId tissue) const noexcept {
  if (settings_.layers.empty()) return tissues_[tissue];
  std::size_t i = settings_.layers.size() - 1;
  while (i > 0 && depth - settings_.surface < settings_.layers[i].from) --i;
  return settings_.layers[i].layer;
}

void TrackingWall::rebase(double depth, double stiffness) noexcept {
  if (stiffness == stiffness_) return;
  if (stiffness_ > 0.0 && depth > wall_) {
    wall_ = depth - stiffness_ / stiffness * (depth - wall_);  // same force before and after
    stop_wall_ = wall_;
    stop_depth_ = depth;
    clock_.restart();
  }
  stiffness_ = stiffness;
}

double TrackingWall::step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept {
  const double x = motion.depth;
  if (!usable(motion)) {
    events.push({EventKind::fault, tissue, wall_, 0.0});
    return 0.0;
  }
  const bool rests = clock_.step(x, motion.stopped || motion.direction == 0);
  const double surface = settings_.surface;
  if (x <= surface) {  // eq. 3, second line
    if (mode_ != Mode::outside) events.push({EventKind::withdrawn, tissue, x, 0.0});
    mode_ = Mode::outside;
    wall_ = surface;
    stiffness_ = 0.0;
    return 0.0;
  }
  // The memory counts from the surface, so that an unused channel has depth 0.
  const double deepest = surface + channels_.deepest();
  if (mode_ == Mode::outside) {
    events.push({EventKind::contact, tissue, x, 0.0});
    mode_ = x < deepest && !settings_.strict ? Mode::free : Mode::insert;
    wall_ = mode_ == Mode::free || settings_.strict ? deepest : surface;
  }
  if (mode_ == Mode::free) {
    if (x <= deepest) return 0.0;
    mode_ = Mode::insert;
    wall_ = deepest;
  }
  channels_.deepen(x - surface);

  const anatomy::TrackingWallTissue& layer = layer_at(x, tissue);
  rebase(x, layer.stiffness);
  if (rests) {
    if (mode_ != Mode::stop) {  // eq. 5
      mode_ = Mode::stop;
      stop_wall_ = wall_;
      stop_depth_ = last_stop_ = x;
      clock_.start();
    }
    const double part = std::min(1.0, clock_.advance() * dt_ / settings_.catch_up);
    wall_ = stop_wall_ + std::max(0.0, stop_depth_ - stop_wall_) * part;  // eq. 6 as a line
  } else if (motion.direction > 0) {
    mode_ = Mode::insert;
    wall_ = std::max(wall_, x - layer.force / layer.stiffness);  // eq. 3, 4
  } else {
    mode_ = Mode::unload;
  }

  if (settings_.strict && x < last_stop_) return 0.0;               // eq. 7, third line
  const double force = layer.stiffness * std::max(0.0, x - wall_);  // eq. 7
  if (force == 0.0 && mode_ == Mode::unload && !settings_.strict) {
    mode_ = Mode::free;
    wall_ = surface + channels_.deepest();
  }
  return std::min(force, settings_.limit);
}

void require_stable_walls(const anatomy::Case& patient, const anatomy::TrackingWallSettings& settings) {
  const anatomy::DeviceLimits& device = patient.description.device;
  const anatomy::TissueLibrary library = effective_tissues(patient);
  for (const anatomy::TissueProperties& tissue : library.tissues())
    require_stable("tracking_wall", "the spring of " + tissue.title, tissue.tracking_wall.stiffness, device);
  for (const anatomy::TrackingWallDepthLayer& layer : settings.layers)
    require_stable("tracking_wall", "the spring of a layer", layer.layer.stiffness, device);
}

double stiffest_wall(const anatomy::TissueLibrary& library) {
  double stiffest = 0.0;
  for (const anatomy::TissueProperties& tissue : library.tissues())
    stiffest = std::max(stiffest, tissue.tracking_wall.stiffness);
  return stiffest;
}

TrackingWall::TrackingWall(const anatomy::Case& patient, const anatomy::TrackingWallSettings& settings, double dt)
    : TrackingWall(effective_tissues(patient), settings, dt, patient.description.device.position_resolution) {
  require_stable_walls(patient, settings);
}

ResistanceForce TrackingWall::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const double force = step(needle.motion, needle.tissue, events);
  return {.along = force, .material = wall_, .in_contact = needle.motion.depth > 0.0};
}

}  // namespace bodkin::forces
