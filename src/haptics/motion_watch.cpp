#include "haptics/motion_watch.h"

#include <algorithm>
#include <cmath>

namespace bodkin::haptics {

namespace {
constexpr double window_time = 0.010;   // s
constexpr double recent_time = 0.003;   // s
constexpr long most_readings = 63;      // that the ring holds besides the newest
constexpr double jump_distance = 5.0;   // mm
constexpr double jump_speed = 3000.0;   // mm/s
constexpr double shortest_share = 0.5;  // of the nominal period: closer readings would look like speed

std::size_t readings_in(double time, double dt) noexcept {
  return static_cast<std::size_t>(std::clamp(std::lround(time / dt), 1L, most_readings));
}
}  // namespace

MotionWatch::MotionWatch(double dt) noexcept
    : dt_(dt), window_(readings_in(window_time, dt)), recent_(readings_in(recent_time, dt)) {}

Vec3 MotionWatch::rate_since(std::size_t wanted, Vec3 Reading::*of) const noexcept {
  const std::size_t back = std::min(wanted, seen_);
  const Reading& now = readings_[seen_ & (capacity - 1)];
  const Reading& earlier = readings_[(seen_ - back) & (capacity - 1)];
  const double elapsed = std::max(time_ - earlier.time, shortest_share * dt_ * static_cast<double>(wanted));
  return (now.*of - earlier.*of) / elapsed;
}

void MotionWatch::reset() noexcept {
  *this = MotionWatch(dt_);
}

void MotionWatch::step(const Pose& hand, const Vec3& velocity, double dt) noexcept {
  const Vec3 position = hand.translation();
  if (seen_ == 0) last_ = hand;
  moved_ = position - last_.translation();
  const Mat3 turn = hand.linear() * last_.linear().transpose();
  turned_ = 0.5 * Vec3(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
  all_turned_ += turned_;
  still_ = seen_ > 0 && moved_.isZero(0.0) && hand.linear() == last_.linear();
  last_ = hand;
  time_ += dt;

  const double distance = moved_.norm();
  const double period = std::max(dt, shortest_share * dt_);
  speed_ = velocity.allFinite() ? velocity.norm() : distance / period;
  jumped_ = distance > jump_distance && distance > jump_speed * period;

  readings_[seen_ & (capacity - 1)] = {position, all_turned_, time_};
  mean_speed_ = rate_since(window_, &Reading::position).norm();
  recent_velocity_ = rate_since(recent_, &Reading::position);
  recent_turning_ = rate_since(recent_, &Reading::turned);
  ++seen_;
}

}  // namespace bodkin::haptics
