#include "haptics/passivity_controller.h"

#include <algorithm>
#include <cmath>

namespace bodkin::haptics {

namespace {
constexpr double forget_out_of_contact = 0.5;  // s out of contact
}

double PassivityController::step(double resistance, double velocity, bool in_contact) noexcept {
  damping_ = 0.0;
  time_outside_ = in_contact ? 0.0 : time_outside_ + dt_;
  if (time_outside_ >= forget_out_of_contact) energy_ = 0.0;

  energy_ += resistance * velocity * dt_;
  const double speed = std::abs(velocity);
  if (energy_ >= 0.0 || speed < threshold_ || speed == 0.0) return resistance;

  damping_ = std::min(-energy_ / (dt_ * velocity * velocity), damping_limit_);
  energy_ += damping_ * velocity * velocity * dt_;
  return std::clamp(resistance + damping_ * velocity, -force_limit_, force_limit_);
}

}  // namespace bodkin::haptics
