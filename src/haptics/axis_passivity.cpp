#include "haptics/axis_passivity.h"

#include <algorithm>
#include <cmath>

namespace bodkin::haptics {

namespace {
constexpr double forget_without_force = 0.5;  // s without force
constexpr double slowest = 0.5;               // mm/s, below which a velocity is noise
constexpr double counts = 0.1;                // N mm that a count of an encoder may make
}  // namespace

void AxisPassivity::reset() noexcept {
  *this = AxisPassivity(damping_limit_);
}

void AxisPassivity::observe(const Vec3& applied, const Vec3& moved, double dt) noexcept {
  time_without_force_ = applied.isZero(0.0) ? time_without_force_ + dt : 0.0;
  if (time_without_force_ >= forget_without_force) energy_.setZero();
  energy_ -= applied.cwiseProduct(moved);
}

Vec3 AxisPassivity::damped(const Vec3& wanted, const Vec3& velocity, double dt, double share, double least) noexcept {
  Vec3 force = wanted;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    damping_[axis] = 0.0;
    const double speed = velocity[axis];
    if (!(std::abs(speed) > slowest)) continue;
    const double needed = energy_[axis] < -counts ? -energy_[axis] / (dt * speed * speed) : 0.0;
    damping_[axis] = share * std::min(std::max(needed, least), damping_limit_);
    force[axis] -= damping_[axis] * speed;
  }
  return force;
}

}  // namespace bodkin::haptics
