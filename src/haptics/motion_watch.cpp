#include "haptics/motion_watch.h"

#include <algorithm>
#include <cmath>

namespace bodkin {

namespace {
constexpr double window_time = 0.010;   // s
constexpr double jump_way = 5.0;        // mm
constexpr double jump_speed = 3000.0;   // mm/s
constexpr double shortest_share = 0.5;  // of the nominal period: readings closer together would look like speed
}  // namespace

MotionWatch::MotionWatch(double dt) noexcept
    : dt_(dt),
      window_(
          static_cast<std::size_t>(std::clamp(std::lround(window_time / dt), 1L, static_cast<long>(capacity) - 1))) {}

void MotionWatch::reset() noexcept {
  *this = MotionWatch(dt_);
}

void MotionWatch::step(const Pose& hand, const Vec3& velocity, double dt) noexcept {
  const Vec3 position = hand.translation();
  if (seen_ == 0) last_ = hand;
  moved_ = position - last_.translation();
  still_ = seen_ > 0 && moved_.isZero(0.0) && hand.linear() == last_.linear();
  last_ = hand;
  time_ += dt;

  const double way = moved_.norm();
  const double period = std::max(dt, shortest_share * dt_);
  speed_ = velocity.allFinite() ? velocity.norm() : way / period;
  jumped_ = way > jump_way && way > jump_speed * period;

  readings_[seen_ & (capacity - 1)] = {position, time_};
  const std::size_t back = std::min(window_, seen_);
  const Reading& earlier = readings_[(seen_ - back) & (capacity - 1)];
  const double elapsed = std::max(time_ - earlier.time, shortest_share * dt_ * static_cast<double>(window_));
  mean_speed_ = (position - earlier.position).norm() / elapsed;
  ++seen_;
}

}  // namespace bodkin
