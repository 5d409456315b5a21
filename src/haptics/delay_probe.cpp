#include "haptics/delay_probe.h"

#include <algorithm>
#include <cmath>

namespace bodkin::haptics {

namespace {
constexpr double pulse_on_time = 0.020;          // s of force in a pulse
constexpr double pulse_time = 0.160;             // s from one to the next
constexpr double fit_time = 0.016;               // s of the response that are examined
constexpr double probe_drift_share = 0.05;       // of the change from tick to tick that enters the drift
constexpr double fit_from = 0.1, fit_to = 0.75;  // of the way made in that time, between which the line is fitted
constexpr double least_way = 0.015;              // mm that the hand must have moved
constexpr double longest_found_delay = 0.012;    // s
}  // namespace

Vec3 DelayProbe::step(const Vec3& position, double dt) noexcept {
  const double place = position.z();
  if (!begun_.load(std::memory_order_acquire) || over_.load(std::memory_order_relaxed)) {
    before_ = place;
    return Vec3::Zero();
  }
  if (tick_ > 0) time_ += dt;
  if (time_ >= pulse_time) {
    if (++pulse_ >= pulses) {
      over_.store(true, std::memory_order_release);
      return Vec3::Zero();
    }
    tick_ = 0;
    time_ = 0.0;
  }
  if (tick_ == 0) start_ = place;
  const double sign = pulse_ % 2 == 0 ? 1.0 : -1.0;
  if (tick_ < longest) moved_[tick_] += sign * (place - start_ - drift_ * static_cast<double>(tick_)) / pulses;
  if (time_ > 0.5 * pulse_time) drift_ += probe_drift_share * (place - before_ - drift_);
  period_ += 0.01 * (dt - (period_ > 0.0 ? period_ : dt)) + (period_ > 0.0 ? 0.0 : dt);
  before_ = place;
  ++tick_;
  return time_ < pulse_on_time ? Vec3(0.0, 0.0, sign * force) : Vec3(Vec3::Zero());
}

std::optional<double> DelayProbe::delay() const noexcept {
  if (!is_over() || !(period_ > 0.0)) return std::nullopt;
  const std::size_t last = std::min(longest - 1, static_cast<std::size_t>(std::lround(fit_time / period_)));
  const double way = moved_[last];
  if (way < least_way) return std::nullopt;
  // t = D + s sqrt(x), by least squares.
  double count = 0.0, sum_r = 0.0, sum_t = 0.0, sum_rr = 0.0, sum_rt = 0.0;
  for (std::size_t i = 1; i <= last; ++i) {
    if (moved_[i] < fit_from * way || moved_[i] > fit_to * way) continue;
    const double root = std::sqrt(moved_[i]), time = static_cast<double>(i) * period_;
    count += 1.0;
    sum_r += root;
    sum_t += time;
    sum_rr += root * root;
    sum_rt += root * time;
  }
  const double spread = count * sum_rr - sum_r * sum_r;
  if (count < 3.0 || !(spread > 0.0)) return std::nullopt;
  const double found = (sum_rr * sum_t - sum_r * sum_rt) / spread;
  if (!(found > -period_) || found > longest_found_delay) return std::nullopt;
  return std::max(0.0, found);
}

}  // namespace bodkin::haptics
