#include "core/motion_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bodkin {

namespace {
constexpr double longest_window = 0.020;     // s
constexpr double dwell_time = 0.020;         // s
constexpr double cutoff = 50.0;              // Hz
constexpr double noiseless_threshold = 0.5;  // mm/s
constexpr double device_threshold = 3.0;     // mm/s
constexpr double leaving_factor = 1.5;       // hysteresis of rest
constexpr double rounding_tolerance = 1e-6;  // mm; a noiseless input is straight to within this
}  // namespace

MotionEstimator::MotionEstimator(double dt, double resolution)
    : tolerance_(resolution + rounding_tolerance),
      threshold_(resolution > 0.0 ? device_threshold : noiseless_threshold),
      window_(std::clamp(static_cast<int>(std::lround(longest_window / dt)), 1, static_cast<int>(capacity) - 1)),
      dwell_(std::max(1, static_cast<int>(std::lround(dwell_time / dt)))),
      filter_(cutoff, dt) {
  for (std::size_t n = 1; n < capacity; ++n) per_sample_[n] = 1.0 / (static_cast<double>(n) * dt);
}

void MotionEstimator::reset() noexcept {
  samples_.fill(0.0);
  begun_ = false;
  newest_ = 0;
  slow_ticks_ = 0;
  direction_ = 0;
  resting_ = true;
  filter_.reset();
}

void MotionEstimator::rebase(double depth) noexcept {
  const double shift = depth - this->depth();
  for (double& sample : samples_) sample += shift;
}

// Every sample within one count of the line through the newest and the n-th sample back: each sample leaves an
// interval of slopes, and the intersection of the intervals is carried along instead of testing all samples again for
// every n.
double MotionEstimator::slope() const noexcept {
  const double now = samples_[newest_];
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  double fitted = 0.0;
  for (int n = 1; n <= window_; ++n) {
    const auto back = static_cast<std::size_t>(n);
    const double distance = now - samples_[(newest_ - back) & (capacity - 1)];
    const double candidate = distance * per_sample_[back];
    if (candidate < lowest || candidate > highest) break;
    fitted = candidate;
    lowest = std::max(lowest, (distance - tolerance_) * per_sample_[back]);
    highest = std::min(highest, (distance + tolerance_) * per_sample_[back]);
  }
  return fitted;
}

AxialMotion MotionEstimator::step(double depth) noexcept {
  if (!begun_) samples_.fill(depth);  // the needle is assumed at rest before its first sample
  begun_ = true;
  newest_ = (newest_ + 1) & (capacity - 1);
  samples_[newest_] = depth;

  const double before = filter_.value();
  const double velocity = filter_.step(slope());
  const double speed = std::abs(velocity);

  slow_ticks_ = speed < threshold_ ? std::min(slow_ticks_ + 1, dwell_) : 0;
  if (slow_ticks_ >= dwell_) resting_ = true;
  if (speed > leaving_factor * threshold_) resting_ = false;
  if (resting_) {
    direction_ = 0;
  } else if (speed > threshold_) {
    direction_ = velocity > 0.0 ? 1 : -1;
  }
  // A stop can fall between two ticks: then only the sign of the velocity reveals it.
  const bool turned = before * velocity < 0.0;
  return {.depth = depth, .velocity = velocity, .direction = direction_, .stopped = resting_ || turned};
}

}  // namespace bodkin
