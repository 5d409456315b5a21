#include "station/probe_contact.h"

#include <algorithm>

#include "anatomy/tissue.h"

namespace bodkin::station {

namespace {

constexpr double step_length = 0.5;  // mm
constexpr int steps = 80;
constexpr int halvings = 12;            // of a step: 0.1 um
constexpr double stiffness = 0.4;       // N/mm
constexpr double damping = 0.002;       // N s/mm
constexpr double highest_force = 15.0;  // N

// Whether the point at continuous `index` is in the body rather than in the air.
bool is_body(const anatomy::TissueVolume& tissues, const Vec3& index) noexcept {
  const Vec3 base = index.array().floor();
  const Vec3 weight = index - base;
  double share = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 offset(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
    if (anatomy::nearest_at_index(tissues, base + offset, anatomy::TissueId{anatomy::tissue::air}) ==
        anatomy::tissue::air)
      continue;
    double part = 1.0;
    for (int axis = 0; axis < 3; ++axis) part *= offset[axis] > 0.0 ? weight[axis] : 1.0 - weight[axis];
    share += part;
  }
  return share > 0.5;
}

}  // namespace

double depth_below_skin(const anatomy::TissueVolume& tissues, const Vec3& tip, const Vec3& axis) noexcept {
  const anatomy::Grid& grid = tissues.grid;
  // Along a line the continuous index is linear, so the grid's axes are needed only twice.
  const Vec3 at_tip = grid.to_index(tip);
  const Vec3 back = at_tip - grid.to_index(tip + axis);  // per mm towards the hand
  double air = steps * step_length, body = air;          // mm before the tip
  if (is_body(tissues, at_tip + air * back)) return air;
  while (body > 0.0) {
    body -= step_length;
    if (is_body(tissues, at_tip + body * back)) {
      for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (air + body);
        (is_body(tissues, at_tip + middle * back) ? body : air) = middle;
      }
      return body;
    }
    air = body;
  }
  return 0.0;
}

ProbeContact::ProbeContact(const anatomy::TissueVolume& tissues, double dt, double resolution,
                           double device_stiffness, double device_damping)
    : tissues_(tissues),
      stiffness_(std::min(stiffness, device_stiffness)),
      damping_(std::min(damping, device_damping)),
      motion_(dt, resolution) {}

Vec3 ProbeContact::step(const Pose& probe) noexcept {
  const Vec3 axis = needle_axis(probe);
  depth_ = depth_below_skin(tissues_, probe.translation(), axis);
  const double speed = motion_.step(depth_).velocity;
  force_ = depth_ > 0.0 ? std::clamp(stiffness_ * depth_ + damping_ * speed, 0.0, highest_force) : 0.0;
  return -force_ * axis;
}

Pose probe_in_hand(const Pose& tool) {
  Pose probe = tool;
  probe.linear().col(1) = tool.linear().col(2);
  probe.linear().col(2) = -tool.linear().col(1);
  return probe;
}

}  // namespace bodkin::station
