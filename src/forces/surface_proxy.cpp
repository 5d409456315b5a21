#include "forces/surface_proxy.h"

#include <algorithm>
#include <cmath>

#include "anatomy/tissue_surface.h"
#include "forces/device_stability.h"
#include "forces/model_input.h"

namespace bodkin::forces {
namespace {

constexpr double least_slide = 1e-9;  // mm: shorter slides are rounding
constexpr double parallel = 1e-12;    // sine squared of the least angle at which two planes make an edge

}  // namespace

ConstrainedMotion constrained_motion(const Vec3& pull, const std::array<Vec3, 3>& normals,
                                     std::size_t count) noexcept {
  const double slack = -1e-12 * pull.norm();
  const auto free = [&](const Vec3& slide, std::size_t but, std::size_t and_but) {
    for (std::size_t i = 0; i < count; ++i) {
      if (i != but && i != and_but && normals[i].dot(slide) < slack) return false;
    }
    return true;
  };
  if (free(pull, count, count)) return {pull, {}, 0};
  for (std::size_t i = 0; i < count; ++i) {  // along a face
    ConstrainedMotion one;
    one.load[i] = -normals[i].dot(pull);
    if (one.load[i] < 0.0) continue;
    one.holding = 1;
    one.slide = pull + one.load[i] * normals[i];
    if (free(one.slide, i, count)) return one;
  }
  for (std::size_t i = 0; i < count; ++i) {  // along an edge
    for (std::size_t j = i + 1; j < count; ++j) {
      const Vec3 edge = normals[i].cross(normals[j]);
      const double sine2 = edge.squaredNorm();
      if (sine2 < parallel) continue;
      const double cosine = normals[i].dot(normals[j]);
      const double into_i = -normals[i].dot(pull), into_j = -normals[j].dot(pull);
      ConstrainedMotion two;
      two.load[i] = (into_i - cosine * into_j) / sine2;
      two.load[j] = (into_j - cosine * into_i) / sine2;
      if (two.load[i] < 0.0 || two.load[j] < 0.0) continue;
      two.holding = 2;
      two.slide = edge * (edge.dot(pull) / sine2);
      if (free(two.slide, i, j)) return two;
    }
  }
  return {Vec3::Zero(), {}, count};  // in a corner
}

SurfaceProxy::SurfaceProxy(const anatomy::SurfaceProxySettings& settings, const anatomy::Surface& surface, double dt)
    : settings_(settings), tree_(surface), dt_(dt) {
  constexpr auto model = "surface_proxy";
  check_tick(model, dt);
  check(settings, model);
}

void SurfaceProxy::reset() noexcept {
  count_ = 0;
  at_rest_ = long_at_rest;
  placed_ = false;
}

// Moves the proxy as near to the tip as faces and friction permit.
void SurfaceProxy::follow(const Vec3& tip) noexcept {
  double friction = at_rest_ < settings_.stick_after ? settings_.dynamic_friction : settings_.static_friction;
  double left = dt_;  // s of this tick in which the proxy has not yet slid
  at_rest_ += dt_;
  count_ = 0;
  for (int round = 0; round < most_rounds; ++round) {
    const ConstrainedMotion held = constrained_motion(tip - proxy_, normals_, count_);
    Vec3 slide = held.slide;
    if (count_ > 0) {
      const double length = slide.norm(), load = held.load[0] + held.load[1] + held.load[2];
      if (length <= least_slide || length <= friction * load * (1.0 + 1e-9)) {  // inside the cone
        count_ = held.holding;
        return;
      }
      friction = settings_.dynamic_friction;
      slide *= 1.0 - friction * load / length;
      if (settings_.viscosity > 0.0) {
        const double spring = settings_.stiffness * left;
        slide *= spring / (spring + settings_.viscosity);
      }
    }
    const SurfaceHit hit = tree_.first_entry(proxy_, slide);
    const double drop = -hit.normal.dot(slide);
    const double part = hit.triangle < 0 ? 1.0 : std::max(0.0, hit.part - clearance / drop);
    proxy_ += part * slide;
    if (count_ > 0 && part * slide.norm() > least_slide) at_rest_ = 0.0;
    if (hit.triangle < 0) {
      // Arrived: at the tip itself, or on the faces, which may have ended during the slide (an edge was passed).
      if (count_ == 0) at_rest_ = long_at_rest;
      if (count_ == 0 || settings_.viscosity > 0.0) return;
      count_ = 0;
      continue;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (held.load[i] <= 0.0) continue;
      // A face met again: the angle between faces is lost in rounding. Stopping is always safe.
      if (normals_[i].cross(hit.normal).squaredNorm() < parallel && normals_[i].dot(hit.normal) > 0.0) return;
      normals_[kept++] = normals_[i];
    }
    if (count_ > 0) left *= 1.0 - part;
    normals_[kept] = hit.normal;
    count_ = kept + 1;
  }
}

Vec3 SurfaceProxy::step(const Vec3& tip, TickEvents& events) noexcept {
  if (!(tip.norm() <= farthest_depth)) {
    events.push({EventKind::fault, anatomy::tissue::air, 0.0, 0.0});
    return Vec3::Zero();
  }
  if (!placed_) proxy_ = tip;
  placed_ = true;
  follow(tip);
  const Vec3 force = -settings_.stiffness * (tip - proxy_);
  const double size = force.norm();
  return size > settings_.limit ? Vec3(force * (settings_.limit / size)) : force;
}

namespace {

// mm before the entry at which the proxy starts: the smooth surface may lie a voxel off the voxels' surface.
constexpr double before_skin = 5.0;

}  // namespace

SurfaceProxyResistance::SurfaceProxyResistance(const anatomy::Case& patient,
                                               const anatomy::SurfaceProxySettings& settings, double dt)
    : model_(settings, anatomy::tissue_surface(patient.tissues, anatomy::body_tissues(), {}), dt),
      stiffness_(settings.stiffness) {
  require_stable_across("surface_proxy", "stiffness", settings.stiffness, patient.description.device);
}

void SurfaceProxyResistance::begin(const Vec3& entry, const Vec3& direction) noexcept {
  TickEvents none;
  direction_ = direction;
  model_.reset();
  model_.step(entry - before_skin * direction, none);
}

ResistanceForce SurfaceProxyResistance::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const Vec3 force = model_.step(needle.tip, events);
  const double along = -force.dot(direction_);
  return {.along = along,
          .across = force + along * direction_,
          .stiffness = model_.constraints() > 0 ? stiffness_ : 0.0,
          .in_contact = needle.motion.depth > 0.0 || model_.constraints() > 0};
}

template <>
ResistanceEntry resistance_with<anatomy::SurfaceProxySettings>() {
  return entry_of<SurfaceProxyResistance>();
}

}  // namespace bodkin::forces
