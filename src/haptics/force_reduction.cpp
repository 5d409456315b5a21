#include "haptics/force_reduction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/repeatable.h"

namespace bodkin::haptics {

namespace {
constexpr double half_force = 0.5, quarter_force = 0.25;
constexpr double calming_window = 0.025;  // s
constexpr double oscillating_fraction =
    0.33;                            // of the oscillation's mean coverage, as some swings of an uneven one are narrow
constexpr double calm_after = 10.0;  // s after which the whole force returns
constexpr double force_return = 1.0;    // s that this takes
constexpr double shortest_watch = 0.1;  // s of motion that decide the next step; at least one cycle
constexpr double turns_within = 0.055;  // s, two windows and a late tick

// The fraction of its width that an oscillation covers in `time`: on average, and if it turns in the middle of that
// time.
double mean_coverage(double frequency, double time) noexcept {
  return std::min(1.0, 2.0 * frequency * time);
}
double coverage_at_turn(double frequency, double time) noexcept {
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

ForceReduction::Step ForceReduction::begin(const Oscillation& oscillation) noexcept {
  if (is_on()) return Step::none_left;
  share_ = half_force;
  damps_ = false;
  watching_ = true;
  oscillation_ = oscillation;
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
  place_ += oscillation_.turns ? turned : moved;
  window_.add(place_);
  all_.add(place_);
  if (for_ < calming_window) return Step::none;
  const double least = oscillating_fraction * oscillation_.width;
  const bool turned_only = since_ < turns_within && since_ > for_;  // a slow hand that turns just now hardly moves
  const bool shakes = window_.most() >= least * mean_coverage(oscillation_.frequency, calming_window) ||
                      (turned_only && all_.most() >= least * coverage_at_turn(oscillation_.frequency, since_));
  for_ = 0.0;
  window_ = {.low = place_, .high = place_};
  if (!shakes) {
    watching_ = since_ < std::max(shortest_watch, 1.0 / oscillation_.frequency);
    return Step::none;
  }
  if (damps_) return Step::none_left;
  damps_ = true;
  share_ = quarter_force;
  watch_anew();
  return Step::damped;
}

}  // namespace bodkin::haptics
