#include "views/moving_detail.h"

#include <algorithm>

namespace bodkin::views {

namespace {

constexpr double coarsest = 6.0, longest_step = 2.0;     // times the finest
constexpr double finer_below = 0.6;                      // of the available time: otherwise it would oscillate
constexpr double largest_change = 1.6, aimed_at = 0.85;  // of the time

}  // namespace

void MovingDetail::took(double seconds) {
  const double share = seconds / in_time;
  if (share <= 1.0 && share >= finer_below) return;
  const double change = std::clamp(share / aimed_at, 1.0 / largest_change, largest_change);
  coarseness_ = std::clamp(coarseness_ * change, 1.0, coarsest);
}

double MovingDetail::step() const {
  return finest_step * std::min(coarseness_, longest_step);
}

double MovingDetail::rays() const {
  return most_rays / std::max(1.0, coarseness_ / longest_step);
}

}  // namespace bodkin::views
