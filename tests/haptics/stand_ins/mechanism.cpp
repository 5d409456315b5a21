#include "tests/haptics/stand_ins/mechanism.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stand_in {

namespace {
constexpr double dt = 0.001;         // s
constexpr double lag = 0.002;        // s, of the motors
constexpr double mass = 0.1;         // kg
constexpr double damping = 1.0;      // N s/m
constexpr double dry = 0.05;         // N
constexpr double hand_spring = 300;  // N/m
constexpr double hand_damper = 3.0;  // N s/m
constexpr double count = 5e-5;       // m, one encoder count
}  // namespace

void Mechanism::step(Board& board, const double (&force)[3], const double (&torque)[3]) noexcept {
  const double follow = 1.0 - std::exp(-dt / lag);
  bool pushed = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const double motor = std::clamp(force[i], -limit_, limit_);
    felt_[i] += (motor - felt_[i]) * follow;
    const double hand = board.hand[i].load() * unit_;
    if (board.firm.load()) {
      speed_[i] = (hand - at_[i]) / dt;
      at_[i] = hand;
    } else {
      const double free =
          speed_[i] + dt / mass * (felt_[i] + hand_spring * (hand - at_[i]) - (damping + hand_damper) * speed_[i]);
      const double loss = std::min(std::abs(free), dt / mass * dry);
      speed_[i] = free - std::copysign(loss, free);
      at_[i] += speed_[i] * dt;
    }
    const double rounded = std::round(at_[i] / count) * count;
    const double seen = board.firm.load() ? at_[i] : rounded;
    velocity_seen_[i] = speed_[i] / unit_;
    seen_[i] = board.troubled_by(Trouble::not_a_number) ? std::numeric_limits<double>::quiet_NaN() : seen / unit_;
    board.force[i] = motor;
    board.torque[i] = torque[i];
    board.position[i] = at_[i] / unit_;
    pushed = pushed || motor != 0.0 || torque[i] != 0.0;
  }
  if (pushed) ++board.pushes;
  if (pushed && board.trouble.load() != Trouble::none && board.troubled_by(board.trouble)) ++board.pushes_in_trouble;
  ++board.ticks;
}

}  // namespace stand_in
