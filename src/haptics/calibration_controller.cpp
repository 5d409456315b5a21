#include "haptics/calibration_controller.h"

#include <algorithm>
#include <cmath>

#include "core/repeatable.h"

namespace bodkin::haptics {

namespace {
constexpr double smoothing = 0.010;  // s, of the velocity
}  // namespace

Control CalibrationController::step(const ControlInput& input) noexcept {
  const Vec3 position = input.needle.translation();
  if (seen_)
    velocity_ += (1.0 - repeatable::exp(-input.dt / smoothing)) * ((position - last_) / input.dt - velocity_);
  last_ = position;
  seen_ = true;

  const Target& target = target_.read();
  const Vec3 pulse = delay_probe_.step(position, input.dt);
  if (!target.carry) return {{pulse, Vec3::Zero()}, 0.0};
  if (!carrying_) first_ = position;
  carrying_ = true;
  const Vec3 way = target.away - gliding_;
  const double step = speed * input.dt, far = way.norm();
  gliding_ += far > step ? Vec3(way * (step / far)) : way;
  Vec3 force = stiffness * (first_ + gliding_ - position) - damping * velocity_;
  if (force.norm() > force_limit) force *= force_limit / force.norm();
  return {{force, Vec3::Zero()}, 0.0};
}

}  // namespace bodkin::haptics
