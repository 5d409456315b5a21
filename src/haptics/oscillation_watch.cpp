#include "haptics/oscillation_watch.h"

#include <algorithm>
#include <cmath>

namespace bodkin::haptics {

namespace {
constexpr double least_force = 0.1;       // N, below which nothing shakes the hand
constexpr double longest_unpushed = 0.1;  // s
constexpr double drift_share = 0.5;       // of a swing that a cycle may drift
constexpr double leak_margin = 1.5;       // times the leak of a wall of the device's own stiffness
}  // namespace

OscillationPattern fast_oscillation(double swing) noexcept {
  return {.swing = swing, .half_period = 1.0 / 60.0, .lasting = 0.1, .gain = -1.0};
}

OscillationPattern driven_oscillation(double swing, double device_stiffness, double dt) noexcept {
  return {
      .swing = swing, .half_period = 1.0 / 20.0, .lasting = 0.25, .gain = leak_margin * device_stiffness * dt / 2.0};
}

OscillationPattern slow_oscillation(double swing, double device_stiffness, double dt) noexcept {
  return {
      .swing = swing, .half_period = 1.0 / 6.0, .lasting = 0.6, .gain = leak_margin * device_stiffness * dt / 2.0};
}

// Over the cycle that ends at this turning point: more energy given than leaked, and the hand returned.
bool OscillationWatch::is_driven(double turned_at) const noexcept {
  if (pattern_.gain < 0.0) return true;
  const bool came_back = std::abs(turned_at - previous_turn_) < drift_share * std::abs(turned_at - turn_);
  // A cycle never closes exactly; the energy from a constant force over the remaining gap does not shake the hand.
  const Vec3 mean = (impulse_ + previous_impulse_) / (since_turn_ + last_half_period_);
  const double by_mean = mean.dot(displacement_ + previous_displacement_);
  return came_back && work_ + previous_work_ - by_mean > pattern_.gain * (speed_integral_ + previous_speed_integral_);
}

bool OscillationWatch::step(const Vec3& moved, const Vec3& force, double dt) noexcept {
  const double size = force.norm();
  unpushed_ = size > least_force ? 0.0 : unpushed_ + dt;
  if (unpushed_ > longest_unpushed) {
    reset();
    return false;
  }
  // A force that swings through zero reverses; the axis keeps its sign, so that every swing of the hand counts once.
  if (size > least_force) axis_ = force * ((force.dot(axis_) < 0.0 ? -1.0 : 1.0) / size);

  place_ += moved.dot(axis_);
  work_ += force.dot(moved);
  speed_integral_ += moved.squaredNorm() / dt;
  impulse_ += dt * force;
  displacement_ += moved;
  since_turn_ += dt;
  if (since_turn_ > pattern_.half_period) oscillating_ = 0.0;
  extreme_ = forwards_ ? std::max(extreme_, place_) : std::min(extreme_, place_);
  const double back = forwards_ ? extreme_ - place_ : place_ - extreme_;
  if (back < pattern_.swing) return false;

  if (!is_driven(extreme_)) {
    oscillating_ = 0.0;
  } else if (since_turn_ <= pattern_.half_period) {
    oscillating_ += since_turn_;
  }
  frequency_ = 1.0 / (since_turn_ + last_half_period_);
  width_ = std::abs(extreme_ - turn_) * axis_.cwiseAbs().maxCoeff();
  last_half_period_ = since_turn_;
  previous_turn_ = turn_;
  turn_ = extreme_;
  previous_work_ = work_;
  previous_speed_integral_ = speed_integral_;
  previous_impulse_ = impulse_;
  previous_displacement_ = displacement_;
  impulse_.setZero();
  displacement_.setZero();
  work_ = speed_integral_ = since_turn_ = 0.0;
  forwards_ = !forwards_;
  extreme_ = place_;
  if (oscillating_ < pattern_.lasting) return false;
  oscillating_ = 0.0;
  return true;
}

}  // namespace bodkin::haptics
