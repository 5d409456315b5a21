#include "haptics/swing_watch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace bodkin::haptics {

namespace {
constexpr double slowest_oscillation = 2.8;  // Hz: 3 Hz, for any period of the ticks
constexpr double faster_than_hands = 19.0;   // Hz
constexpr double hand_acceleration = 2.0e4;  // mm/s^2
constexpr double persists = 0.85;            // of a cycle's width, at least, for the next one
constexpr double unsteady = 0.25;            // of a period by which the next may differ
constexpr double fast_swings = 2.0;          // times the least swing
constexpr double lasting_swings = 1.5;       // the same for a swing that lasts
constexpr double at_turn = 0.2;              // of the least swing, within which the hand is at its turning point

// How equal, how many and how long the cycles of a swing must be to rule out a hand.
struct Evenness {
  double time = 0.0;         // of the shortest period by which the longest may exceed it, beyond two ticks
  double width = 0.0;        // of the narrowest width, beyond one least swing
  double half_cycles = 0.0;  // at least
  double lasting = 0.0;      // s, at least
};
constexpr double slower_than_tremor = 8.5;  // Hz
constexpr Evenness of_a_tremor{0.15, 0.3, 0.0, 1.2};
constexpr Evenness of_a_rhythm{0.05, 0.1, 24.0, 0.0};
}  // namespace

double SwingWatch::allowed(double frequency) const noexcept {
  const double fast = fast_swings * least_;
  if (frequency >= faster_than_hands) return fast;
  const double turn_rate = 2.0 * std::numbers::pi * std::max(frequency, slowest_oscillation);
  return std::max(fast, 2.0 * hand_acceleration / (turn_rate * turn_rate));
}

bool SwingWatch::is_shaken(const Axis& axis) noexcept {
  if (axis.count <= static_cast<int>(axis.last.size())) return false;  // the first one began in the middle
  const auto& swing = axis.last;
  const double width = std::min(swing[0].width, swing[1].width);
  double time = 0.0, longest = 0.0;
  for (std::size_t i = 0; i < swing.size(); i += 2) {
    time += swing[i].time + swing[i + 1].time;
    longest = std::max(longest, swing[i].time + swing[i + 1].time);
  }
  const double period = time * 2.0 / static_cast<double>(swing.size());
  for (std::size_t i = 0; i < swing.size(); i += 2) {
    if (i > 0 && swing[i - 2].width + swing[i - 1].width < persists * (swing[i].width + swing[i + 1].width))
      return false;
    if (std::abs(swing[i].time + swing[i + 1].time - period) > unsteady * period) return false;
  }
  // Every cycle must be too regular for a hand: counts of an encoder, and a hand that changes its pace, make single
  // cycles seem shorter.
  if (width <= allowed(1.0 / longest)) return false;
  const double frequency = 1.0 / period;
  frequency_ = frequency;
  width_ = width;
  return true;
}

// A cycle ends with every turning point, half a cycle after the one before.
void SwingWatch::watch_lasting(Axis& axis, double dt) noexcept {
  const auto& swing = axis.last;
  const double period = swing[0].time + swing[1].time, width = 0.5 * (swing[0].width + swing[1].width);
  if (axis.count < 3 || width <= lasting_swings * least_) {
    axis.widest = axis.longest = axis.lasting = axis.half_cycles = 0.0;
    axis.narrowest = axis.shortest = std::numeric_limits<double>::infinity();
    return;
  }
  axis.widest = std::max(axis.widest, width);
  axis.narrowest = std::min(axis.narrowest, width);
  axis.longest = std::max(axis.longest, period);
  axis.shortest = std::min(axis.shortest, period);
  const Evenness& wanted = axis.longest * slower_than_tremor > 1.0 ? of_a_rhythm : of_a_tremor;
  const bool equal = axis.longest - axis.shortest <= wanted.time * axis.shortest + 2.0 * dt &&
                     axis.widest - axis.narrowest <= wanted.width * axis.narrowest + least_;
  axis.lasting += swing[0].time;
  axis.half_cycles += 1.0;
  if (!equal) {
    axis.widest = axis.narrowest = width;
    axis.longest = axis.shortest = period;
    axis.lasting = axis.half_cycles = 0.0;
  }
  if (axis.lasting < wanted.lasting || axis.half_cycles < wanted.half_cycles) return;
  axis.lasting = axis.half_cycles = 0.0;
  lasts_ = true;
  frequency_ = 1.0 / period;
  width_ = width;
}

// One axis. A turning point is detected once the hand has returned by `least_`. Its time is the middle of the hand's
// stay there: a coarse encoder shows it earlier by half the stay.
bool SwingWatch::step(Axis& axis, double moved, double dt) noexcept {
  axis.place += moved;
  axis.since_extreme += dt;
  if (axis.forwards ? axis.place > axis.extreme : axis.place < axis.extreme) {
    axis.since_turn += axis.since_extreme;
    axis.since_extreme = 0.0;
    axis.extreme = axis.place;
    axis.dwelt = 0.0;
  } else if (std::abs(axis.extreme - axis.place) < at_turn * least_) {
    axis.dwelt = axis.since_extreme;
  }
  const double longest = 0.5 / slowest_oscillation;
  if (std::max(axis.since_turn, axis.since_extreme) > longest) axis.count = 0;
  if (std::abs(axis.extreme - axis.place) < least_) return false;

  std::rotate(axis.last.begin(), axis.last.end() - 1, axis.last.end());
  axis.last.front() = {std::abs(axis.extreme - axis.turn), std::max(axis.since_turn + 0.5 * axis.dwelt, dt)};
  axis.count = axis.since_turn > longest ? 0 : axis.count + 1;
  axis.turn = axis.extreme;
  axis.since_turn = axis.since_extreme - 0.5 * axis.dwelt;
  axis.dwelt = 0.0;
  axis.since_extreme = 0.0;
  axis.extreme = axis.place;
  axis.forwards = !axis.forwards;
  watch_lasting(axis, dt);
  return is_shaken(axis);
}

bool SwingWatch::step(const Vec3& moved, double dt) noexcept {
  bool shaken = false;
  lasts_ = false;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!step(axes_[i], moved[static_cast<Eigen::Index>(i)], dt)) continue;
    axis_ = static_cast<int>(i);
    shaken = true;
  }
  return shaken;
}

}  // namespace bodkin::haptics
