#include "forces/volume_proxy.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "forces/device_stability.h"
#include "forces/model_input.h"
#include "forces/needle_law.h"

namespace bodkin::forces {
namespace {

constexpr double release_speed = 200.0;  // mm/s

anatomy::ProxyProperties blend(const anatomy::ProxyProperties& a, const anatomy::ProxyProperties& b,
                               double part) noexcept {
  const auto mix = [part](double from, double to) { return from + (to - from) * part; };
  return {mix(a.penetrability, b.penetrability), mix(a.friction, b.friction), mix(a.drag, b.drag),
          mix(a.viscosity, b.viscosity)};
}

}  // namespace

Vec3 advance_proxy(const Vec3& proxy, const Vec3& tip, const Vec3& normal, const anatomy::ProxyProperties& properties,
                   double stiffness, anatomy::ProxyVariant variant, bool two_sided, double dt) noexcept {
  const Vec3 stretch = tip - proxy;              // d
  const double along = stretch.dot(normal);      // dn
  const Vec3 across = stretch - along * normal;  // t
  const double wall = properties.penetrability / stiffness;
  Vec3 moved = proxy;
  if (along > wall) {
    moved += normal * (along - wall);  // eq. 3
  } else if (!two_sided && along < 0.0) {
    moved += normal * along;
  } else if (two_sided && along < -wall) {
    moved += normal * (along + wall);
  }
  const double slide = across.norm(), hold = properties.friction / stiffness;
  if (slide > hold) moved += across * ((slide - hold) / slide);  // eq. 4
  const Vec3 step = moved - proxy;                               // e
  if (variant == anatomy::ProxyVariant::viscous) {
    return proxy + step * (stiffness * dt / (stiffness * dt + properties.viscosity));
  }
  const double length = step.norm(), back = properties.drag / stiffness;
  return length > back ? Vec3(moved - step * (back / length)) : (back > 0.0 ? proxy : moved);  // eq. 5
}

VolumeProxy::VolumeProxy(const anatomy::TissueLibrary& library, const anatomy::VolumeProxySettings& settings,
                         const HapticField& field, double dt)
    : settings_(settings),
      tissues_(library.by_id(&anatomy::TissueProperties::volume_proxy)),
      field_(&field),
      dt_(dt) {
  constexpr auto model = "volume_proxy";
  check_tick(model, dt);
  check(settings, model);
  check_tissues(library, &anatomy::TissueProperties::volume_proxy, model);
}

anatomy::ProxyProperties VolumeProxy::properties(const FieldSample& here) const noexcept {
  const auto& points = settings_.transfer;
  if (points.empty()) return tissues_[field_->tissue(proxy_)].properties;
  const auto above =
      std::upper_bound(points.begin(), points.end(), here.value,
                       [](double value, const anatomy::TransferPoint& point) { return value < point.value; });
  if (above == points.begin()) return points.front().properties;
  if (above == points.end()) return points.back().properties;
  const auto below = above - 1;
  return blend(below->properties, above->properties, (here.value - below->value) / (above->value - below->value));
}

// A proxy that was held back advances at release_speed at any tick rate: as far as the tip has moved in the tick,
// plus that step.
Vec3 VolumeProxy::released(const Vec3& wanted, const Vec3& tip) const noexcept {
  const Vec3 move = wanted - proxy_;
  const double length = move.norm(), most = (tip - last_tip_).norm() + release_speed * dt_;
  return length > most ? Vec3(proxy_ + move * (most / length)) : wanted;
}

Vec3 VolumeProxy::step(const Vec3& tip, const Rail* rail, TickEvents& events) noexcept {
  if (!(tip.norm() <= farthest_depth)) {
    events.push({EventKind::fault, anatomy::tissue::air, 0.0, 0.0});
    return Vec3::Zero();
  }
  if (!placed_) proxy_ = last_tip_ = tip;
  placed_ = true;
  const FieldSample here = field_->sample(proxy_);
  if (here.inside) {
    anatomy::ProxyProperties local = properties(here);
    const double slope = here.gradient.norm();
    Vec3 normal = Vec3::Zero();
    if (slope > settings_.gradient_least) {
      normal = here.gradient / slope;
      const double part = std::min(slope / settings_.gradient_reference, 1.0);
      local.penetrability *= part * part * (3.0 - 2.0 * part);
    }
    const Vec3 wanted =
        advance_proxy(proxy_, tip, normal, local, settings_.stiffness, settings_.variant, settings_.two_sided, dt_);
    proxy_ = settings_.variant == anatomy::ProxyVariant::drag ? released(wanted, tip) : wanted;
  } else {
    proxy_ = tip;
  }
  last_tip_ = tip;
  if (rail != nullptr) proxy_ = rail->project(proxy_);
  const Vec3 force = -settings_.stiffness * (tip - proxy_);  // eq. 1
  const double size = force.norm();
  return size > settings_.limit ? Vec3(force * (settings_.limit / size)) : force;
}

VolumeProxy::VolumeProxy(const anatomy::Case& patient, const anatomy::VolumeProxySettings& settings,
                         std::unique_ptr<HapticField> field, double dt)
    : VolumeProxy(effective_tissues(patient), settings, *field, dt) {
  own_field_ = std::move(field);
}

VolumeProxy::VolumeProxy(const anatomy::Case& patient, const anatomy::VolumeProxySettings& settings, double dt)
    : VolumeProxy(patient, settings,
                  std::make_unique<HapticField>(patient.ct, patient.tissues, patient.library, settings.field), dt) {
  require_stable_across("volume_proxy", "stiffness", settings.stiffness, patient.description.device);
}

void VolumeProxy::begin(const Vec3& entry, const Vec3& direction) noexcept {
  reset();
  entry_ = entry;
  direction_ = direction;
}

ResistanceForce VolumeProxy::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const Vec3 force = step(needle.tip, needle.rail, events);
  const double along = -force.dot(direction_);
  return {.along = along,
          .across = force + along * direction_,
          .stiffness = settings_.stiffness,
          .material = (proxy_ - entry_).dot(direction_),
          .in_contact = needle.motion.depth > 0.0};
}

template <>
ResistanceEntry resistance_with<anatomy::VolumeProxySettings>() {
  return entry_of<VolumeProxy>();
}

}  // namespace bodkin::forces
