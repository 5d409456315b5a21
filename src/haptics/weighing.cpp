#include "haptics/weighing.h"

#include <algorithm>
#include <cmath>

namespace bodkin {

namespace {
constexpr double smoothing = 0.010;  // s, of the velocity
}  // namespace

Control Weighing::step(const ControlInput& input) noexcept {
  const Vec3 position = input.needle.translation();
  if (seen_) velocity_ += (1.0 - std::exp(-input.dt / smoothing)) * ((position - last_) / input.dt - velocity_);
  last_ = position;
  seen_ = true;

  const Wish& wish = above_.read();
  if (!wish.carry) return {};
  if (!carrying_) first_ = position;
  carrying_ = true;
  const double way = speed * input.dt;
  gliding_ += std::clamp(wish.above - gliding_, -way, way);
  Vec3 force = stiffness * (first_ + gliding_ * Vec3::UnitZ() - position) - damping * velocity_;
  if (force.norm() > most) force *= most / force.norm();
  return {{force, Vec3::Zero()}, 0.0};
}

}  // namespace bodkin
