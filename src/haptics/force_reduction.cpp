#include "haptics/force_reduction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/repeatable.h"

namespace bodkin::haptics {

namespace {
constexpr double half_force = 0.5, quarter_force = 0.25;
constexpr double calming_window = 0.025;  // s
constexpr double still_shakes = 0.33;     // of the shaking's usual way, for some swings of an uneven one are narrow
constexpr double calm_after = 10.0;       // s after which the whole force comes back
constexpr double force_return = 1.0;      // s that this takes
constexpr double shortest_watch = 0.1;    // s for which the motion decides about the next step; one cycle at least
constexpr double turns_within = 0.055;    // s, two windows and a late tick

// The share of its width that a shaking covers in `time`: in the mean, and where it turns in the middle of that time.
double usual_way(double frequency, double time) noexcept {
  return std::min(1.0, 2.0 * frequency * time);
}
double way_at_a_turn(double frequency, double time) noexcept {
  return 0.5 * (1.0 - repeatable::cos(std::numbers::pi * std::min(1.0, frequency * time)));
}
}  // namespace

void ForceReduction::Reach::add(const Vec3& place) noexcept {
  low = low.cwiseMin(place);
  high = high.cwiseMax(place);
}

void ForceReduction::watch_anew() noexcept {
  since_ = for_ = 0.0;
  place_ = Vec3::Zero();
  window_ = all_ = Reach();
}

ForceReduction::Step ForceReduction::begin(const Shaking& shaking) noexcept {
  if (is_on()) return Step::none_left;
  share_ = half_force;
  damps_ = false;
  watching_ = true;
  shaking_ = shaking;
  watch_anew();
  return Step::softer;
}

ForceReduction::Step ForceReduction::step(const Vec3& moved, const Vec3& turned, double dt) noexcept {
  if (!is_on()) return Step::none;
  since_ += dt;
  if (since_ > calm_after) {
    damps_ = watching_ = false;
    share_ = std::min(1.0, share_ + half_force * dt / force_return);
    return Step::none;
  }
  if (!watching_) return Step::none;
  for_ += dt;
  place_ += shaking_.turns ? turned : moved;
  window_.add(place_);
  all_.add(place_);
  if (for_ < calming_window) return Step::none;
  const double least = still_shakes * shaking_.width;
  const bool turned_only = since_ < turns_within && since_ > for_;  // a slow hand that turns just now hardly moves
  const bool shakes = window_.most() >= least * usual_way(shaking_.frequency, calming_window) ||
                      (turned_only && all_.most() >= least * way_at_a_turn(shaking_.frequency, since_));
  for_ = 0.0;
  window_ = {.low = place_, .high = place_};
  if (!shakes) {
    watching_ = since_ < std::max(shortest_watch, 1.0 / shaking_.frequency);
    return Step::none;
  }
  if (damps_) return Step::none_left;
  damps_ = true;
  share_ = quarter_force;
  watch_anew();
  return Step::damped;
}

}  // namespace bodkin::haptics
