#include "anatomy/breathing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bodkin::anatomy {

namespace {

constexpr double seconds_in_minute = 60.0;
constexpr int newton_steps = 6;  // from an error below 1; each step squares it

std::uint64_t ticks_of(double time, double dt) noexcept {
  return static_cast<std::uint64_t>(std::max(1.0, std::round(time / dt)));
}

// sin(x) for |x| <= pi / 2 to 1e-13, by its series: the library's differs from processor to processor.
double sine(double x) noexcept {
  constexpr int last = 19;
  const double square = x * x;
  double sum = 1.0;
  for (int power = last; power > 1; power -= 2) sum = 1.0 - sum * square / static_cast<double>(power * (power - 1));
  return x * sum;
}

}  // namespace

BreathClock::BreathClock(const Breathing& breathing, double dt) noexcept
    : period_(ticks_of(seconds_in_minute / breathing.rate, dt)),
      longest_hold_(ticks_of(breathing.longest_hold, dt)),
      pause_(breathing.pause) {}

void BreathClock::set(const BreathState& moment) noexcept {
  now_ = moment;
  now_.phase %= period_;
  holds_ = false;
  drawn_in_ = drawn_in_at(now_.phase);
}

double BreathClock::step(bool hold) noexcept {
  holds_ = hold && now_.phase == 0 && now_.held < longest_hold_;
  if (holds_) {
    ++now_.held;
    return drawn_in_;
  }
  if (++now_.phase >= period_) now_.phase = 0;
  if (now_.phase == 0) now_.held = 0;
  return drawn_in_ = drawn_in_at(now_.phase);
}

double BreathClock::drawn_in_at(std::uint64_t phase) const noexcept {
  const double share = static_cast<double>(std::min(phase, period_ - phase)) / static_cast<double>(period_);
  const double wave = sine(std::numbers::pi * share);
  double drawn_in = 1.0;
  for (int i = 0; i < pause_; ++i) drawn_in *= wave * wave;
  return drawn_in;
}

double BreathField::weight(const Vec3& material) const noexcept {
  const double inside = 1.0 - (material - centre_).squaredNorm() / radius_squared_;
  return inside > 0.0 ? inside * inside : 0.0;
}

// The material point is place - a m with one unknown a = b w, 0 to 1: a - b w(place - a m) increases with a, because
// the motion is short compared to the radius (Breathing).
Vec3 BreathField::material(const Vec3& place, double drawn_in) const noexcept {
  double share = drawn_in * weight(place);
  for (int step = 0; step < newton_steps; ++step) {
    const Vec3 from_centre = place - share * motion_ - centre_;
    const double inside = std::max(0.0, 1.0 - from_centre.squaredNorm() / radius_squared_);
    const double slope = 1.0 - drawn_in * 4.0 * inside * from_centre.dot(motion_) / radius_squared_;
    share -= (share - drawn_in * inside * inside) / slope;
  }
  return place - share * motion_;
}

}  // namespace bodkin::anatomy
