#include "tests/haptics/mocks/mechanism.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace mock {

namespace {
constexpr double dt = 0.001;          // s
constexpr double lag = 0.002;         // s, of the motors
constexpr double mass = 0.1;          // kg
constexpr double damping = 1.0;       // N s/m
constexpr double dry = 0.05;          // N
constexpr double hand_spring = 300;   // N/m
constexpr double hand_damper = 3.0;   // N s/m
constexpr double loose_spring = 40;   // N/m
constexpr double loose_damper = 0.5;  // N s/m
constexpr double held_for = 3.0;      // s
constexpr double handle = 0.6;        // N, of a device that nobody holds
constexpr double lever = 0.05;        // m from the device's point to the tip
constexpr double sweep_speed = 0.04;  // m/s
}  // namespace

void Mechanism::follow_habit(Board& board) noexcept {
  time_ += dt;
  const auto reach = [&](double x, double y, double z) {
    board.hand[0] = x / unit_;
    board.hand[1] = y / unit_;
    board.hand[2] = z / unit_;
  };
  switch (board.habit.load()) {
    case Hand::still:
    case Hand::loose:
    case Hand::gone:
      return;
    case Hand::wander:
      return reach(0.04 * std::sin(9.0 * time_), 0.03 * std::sin(7.0 * time_), 0.05 * std::sin(5.0 * time_));
    case Hand::sweep:
      return reach(0.0, std::min(0.08, sweep_speed * time_) - 0.04, 0.0);
    case Hand::swivel: {
      // Turned about the first axis, then about the second.
      const double a = 0.6 * std::sin(9.0 * time_), b = 0.6 * std::cos(7.0 * time_);
      const double turn[9] = {
          std::cos(b),  std::sin(b) * std::sin(a), std::sin(b) * std::cos(a), 0.0, std::cos(a), -std::sin(a),
          -std::sin(b), std::cos(b) * std::sin(a), std::cos(b) * std::cos(a)};
      for (std::size_t i = 0; i < 9; ++i) board.turn[i] = turn[i];
      return reach(-lever * turn[2], -lever * turn[5], -lever * turn[8]);
    }
  }
}

void Mechanism::keep_times(Board& board, bool pushed) noexcept {
  const std::int64_t now = std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
  const std::int64_t gap = last_ == 0 ? 0 : now - last_;
  last_ = now;
  if (!board.watched || board.ticks < board.from_tick || board.zero_at != 0) return;
  if (board.watched_at == 0) {
    board.watched_at = now;
  } else {
    board.longest_gap = std::max(board.longest_gap.load(), gap);
  }
  if (!pushed) board.zero_at = now;
}

void Mechanism::step(Board& board, const double (&force)[3], const double (&torque)[3]) noexcept {
  const double follow = 1.0 - std::exp(-dt / lag);
  bool pushed = false;
  follow_habit(board);
  const bool loose = board.habit.load() == Hand::loose;
  const bool firm = board.firm.load() && !loose;
  const double spring = loose ? loose_spring : hand_spring, damper = loose ? loose_damper : hand_damper;
  const bool alone = board.habit.load() == Hand::gone && time_ > held_for;
  for (std::size_t i = 0; i < 3; ++i) {
    const double motor = std::clamp(force[i], -limit_, limit_);
    felt_[i] += (motor - felt_[i]) * follow;
    const double hand = board.hand[i].load() * unit_;
    if (firm && !alone) {
      speed_[i] = (hand - at_[i]) / dt;
      at_[i] = hand;
    } else {
      const double hold = alone ? (i == 2 ? -handle : 0.0) : spring * (hand - at_[i]) - damper * speed_[i];
      const double free = speed_[i] + dt / mass * (felt_[i] + hold - damping * speed_[i]);
      const double loss = std::min(std::abs(free), dt / mass * dry);
      speed_[i] = free - std::copysign(loss, free);
      at_[i] += speed_[i] * dt;
    }
    const double rounded = std::round(at_[i] / count_) * count_;
    const double seen = firm && !alone ? at_[i] : rounded;
    board.force[i] = motor;
    board.torque[i] = torque[i];
    board.position[i] = at_[i] / unit_;
    pushed = pushed || motor != 0.0 || torque[i] != 0.0;
    if (board.troubled_by(Trouble::stuck)) continue;
    velocity_seen_[i] = speed_[i] / unit_;
    seen_[i] = board.troubled_by(Trouble::not_a_number) ? std::numeric_limits<double>::quiet_NaN() : seen / unit_;
  }
  keep_times(board, pushed);
  if (pushed) ++board.pushes;
  if (pushed && board.trouble.load() != Trouble::none && board.troubled_by(board.trouble)) ++board.pushes_in_trouble;
  ++board.ticks;
}

}  // namespace mock
