#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>

#include "core/geometry.h"

namespace bodkin::haptics {

// Measures how long a force takes to reach the hand: short pulses of a small force, alternating along the vertical,
// and the mean of the encoder's readings after each. A mass pushed from the time D on has moved by x = a (t - D)^2 /
// 2, so the root of x is a straight line in t that begins at D; the line is fitted to the first part of the motion,
// before the hand's own spring matters. step() belongs to the servo's thread, is noexcept and allocates nothing; the
// other functions belong to one observer.
class DelayProbe {
 public:
  static constexpr double force = 1.0;  // N, which the guard ramps up within two ticks, 0.5 ms late on average
  static constexpr int pulses = 32;

  // Starts the pulses, from the next tick on, for about five seconds; once only.
  void begin() noexcept { begun_.store(true, std::memory_order_release); }
  bool is_over() const noexcept { return over_.load(std::memory_order_acquire); }
  // s from the tick that commands a force to the hand's motion, including the delay of our own loop; empty if the
  // hand did not follow clearly. Valid after is_over().
  std::optional<double> delay() const noexcept;

  // `position`: mm, of the hand in the operator's frame; `dt`: s since the last tick. Returns N on the hand.
  Vec3 step(const Vec3& position, double dt) noexcept;

 private:
  static constexpr std::size_t longest = 128;  // ticks kept of a pulse

  std::atomic<bool> begun_{false}, over_{false};
  int pulse_ = 0;
  double time_ = 0.0;    // s in the pulse
  double period_ = 0.0;  // s, mean
  std::size_t tick_ = 0;
  double start_ = 0.0;                   // mm where the pulse began
  double before_ = 0.0, drift_ = 0.0;    // mm of the previous tick, mm per tick before the pulse
  std::array<double, longest> moved_{};  // mm along the pulses, by ticks since their beginning, summed
};

}  // namespace bodkin::haptics
