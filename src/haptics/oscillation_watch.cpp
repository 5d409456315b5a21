#include "haptics/oscillation_watch.h"

#include <algorithm>
#include <cmath>

namespace bodkin::haptics {

namespace {
constexpr double least_force = 0.1;       // N, below which nothing shakes the hand
constexpr double longest_unpushed = 0.1;  // s
constexpr double drift_share = 0.5;       // of a swing that a cycle may lead on
constexpr double leak_margin = 1.5;       // times what a wall of the device's own stiffness leaks
}  // namespace

ShakingPattern fast_shaking(double swing) noexcept {
  return {.swing = swing, .half_period = 1.0 / 60.0, .lasting = 0.1, .gain = -1.0};
}

ShakingPattern driven_shaking(double swing, double device_stiffness, double dt) noexcept {
  return {
      .swing = swing, .half_period = 1.0 / 20.0, .lasting = 0.25, .gain = leak_margin * device_stiffness * dt / 2.0};
}

ShakingPattern slow_shaking(double swing, double device_stiffness, double dt) noexcept {
  return {
      .swing = swing, .half_period = 1.0 / 6.0, .lasting = 0.6, .gain = leak_margin * device_stiffness * dt / 2.0};
}

// Over the cycle that ends with this turning point: more given than leaked, and the hand came back.
bool OscillationWatch::is_driven(double turned_at) const noexcept {
  if (pattern_.gain < 0.0) return true;
  const bool came_back = std::abs(turned_at - turn_before_) < drift_share * std::abs(turned_at - turn_);
  // A cycle never closes quite; what a force that stays gives the hand on the way that is left shakes nobody.
  const Vec3 mean = (pushed_ + pushed_before_) / (since_turn_ + turn_took_);
  const double by_mean = mean.dot(gone_ + gone_before_);
  return came_back && given_ + given_before_ - by_mean > pattern_.gain * (way_ + way_before_);
}

bool OscillationWatch::step(const Vec3& moved, const Vec3& force, double dt) noexcept {
  const double size = force.norm();
  unpushed_ = size > least_force ? 0.0 : unpushed_ + dt;
  if (unpushed_ > longest_unpushed) {
    reset();
    return false;
  }
  // A force that swings through zero turns about; the axis keeps its sign, so that every swing of the hand counts
  // once.
  if (size > least_force) axis_ = force * ((force.dot(axis_) < 0.0 ? -1.0 : 1.0) / size);

  place_ += moved.dot(axis_);
  given_ += force.dot(moved);
  way_ += moved.squaredNorm() / dt;
  pushed_ += dt * force;
  gone_ += moved;
  since_turn_ += dt;
  if (since_turn_ > pattern_.half_period) shaking_ = 0.0;
  extreme_ = forwards_ ? std::max(extreme_, place_) : std::min(extreme_, place_);
  const double back = forwards_ ? extreme_ - place_ : place_ - extreme_;
  if (back < pattern_.swing) return false;

  if (!is_driven(extreme_)) {
    shaking_ = 0.0;
  } else if (since_turn_ <= pattern_.half_period) {
    shaking_ += since_turn_;
  }
  frequency_ = 1.0 / (since_turn_ + turn_took_);
  width_ = std::abs(extreme_ - turn_) * axis_.cwiseAbs().maxCoeff();
  turn_took_ = since_turn_;
  turn_before_ = turn_;
  turn_ = extreme_;
  given_before_ = given_;
  way_before_ = way_;
  pushed_before_ = pushed_;
  gone_before_ = gone_;
  pushed_.setZero();
  gone_.setZero();
  given_ = way_ = since_turn_ = 0.0;
  forwards_ = !forwards_;
  extreme_ = place_;
  if (shaking_ < pattern_.lasting) return false;
  shaking_ = 0.0;
  return true;
}

}  // namespace bodkin::haptics
