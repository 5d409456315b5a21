#include "haptics/pointer_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bodkin::haptics {

namespace {

constexpr double most_tilt = std::numbers::pi / 3.0;  // rad

// One step of T^2 x'' + 2 T x' + x = goal in closed form.
void follow(const Vec3& goal, double time_constant, double dt, Vec3& x, Vec3& v) noexcept {
  const double pace = 1.0 / time_constant;
  const double fade = std::exp(-pace * dt);
  const Vec3 offset = x - goal;
  const Vec3 slope = v + pace * offset;
  x = goal + fade * (offset + dt * slope);
  v = fade * (v - pace * dt * slope);
}

// The needle points down, its first axis to the operator's right; then it is tilted, first away, then to the right.
Mat3 rotation_of(const Vec3& tilt) noexcept {
  const Mat3 down = Vec3(1.0, -1.0, -1.0).asDiagonal();
  return (Eigen::AngleAxisd(tilt.y(), Vec3::UnitX()) * Eigen::AngleAxisd(-tilt.x(), Vec3::UnitY()))
             .toRotationMatrix() *
         down;
}

}  // namespace

void PointerInput::move(double right, double away, bool turning) noexcept {
  (turning ? state_.tilted_right : state_.right) += state_.share * right;
  (turning ? state_.tilted : state_.away) += state_.share * away;
}

void PointerInput::key(Key key, bool down) noexcept {
  down_[static_cast<int>(key)] = down;
  const auto axis = [this](Key plus, Key minus) {
    return (down_[static_cast<int>(plus)] ? 1.0 : 0.0) - (down_[static_cast<int>(minus)] ? 1.0 : 0.0);
  };
  state_.keys = {axis(Key::right, Key::left), axis(Key::away, Key::near), axis(Key::inwards, Key::outwards)};
  state_.tilt_key = axis(Key::tilt_away, Key::tilt_near);
}

void PointerInput::release() noexcept {
  std::fill(std::begin(down_), std::end(down_), false);
  state_.keys.setZero();
  state_.tilt_key = 0.0;
}

const Pose& PointerHand::step(const PointerState& state, double dt) noexcept {
  if (!begun_) last_ = state;
  begun_ = true;
  const double held = state.share * dt;
  tilt_goal_.x() += settings_.turn * (state.tilted_right - last_.tilted_right);
  tilt_goal_.y() += settings_.turn * (state.tilted - last_.tilted) + settings_.turn_speed * held * state.tilt_key;
  tilt_goal_ = tilt_goal_.cwiseMax(-most_tilt).cwiseMin(most_tilt);
  const Vec3 inwards = rotation_of(tilt_goal_).col(2);
  goal_.x() += settings_.pixel * (state.right - last_.right) + settings_.speed * held * state.keys.x();
  goal_.y() += settings_.pixel * (state.away - last_.away) + settings_.speed * held * state.keys.y();
  goal_ += inwards * (settings_.step * (state.pushed - last_.pushed) + settings_.speed * held * state.keys.z());
  goal_ = goal_.cwiseMax(-settings_.reach).cwiseMin(settings_.reach);
  last_ = state;

  follow(goal_, settings_.smoothing, dt, position_, velocity_);
  follow(tilt_goal_, settings_.smoothing, dt, tilt_, tilt_rate_);
  hand_.translation() = position_;
  hand_.linear() = rotation_of(tilt_);
  return hand_;
}

}  // namespace bodkin::haptics
