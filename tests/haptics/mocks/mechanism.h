#pragma once

#include <array>

#include "tests/haptics/mocks/board.h"

namespace mock {

// The moving parts of a desktop device and the hand on it, along three axes: a mass with viscous and dry friction,
// the motors' force up to a limit and with a lag of 2 ms, a spring and damper to the hand's intended position, and
// encoders with whole counts.
//
//   m x'' = F - c x' - f sign(x') + k (h - x) - d x'
class Mechanism {
 public:
  // `unit`: m per unit of the vendor's lengths. `limit`: N along each axis. `count`: m, of the encoders.
  Mechanism(double unit, double limit, double count = 5e-5) : unit_(unit), limit_(limit), count_(count) {}

  // One millisecond under the force that the motors are told (N; zero when they are off). Writes events to the board.
  void step(Board& board, const double (&force)[3], const double (&torque)[3]) noexcept;

  // Encoder readings, vendor's unit.
  const std::array<double, 3>& position() const noexcept { return seen_; }
  const std::array<double, 3>& velocity() const noexcept { return velocity_seen_; }

 private:
  void follow_habit(Board& board) noexcept;
  void keep_times(Board& board, bool pushed) noexcept;

  double unit_, limit_, count_;
  double time_ = 0.0;                     // s
  std::int64_t last_ = 0;                 // ns of the steady clock, the step before
  std::array<double, 3> at_{}, speed_{};  // m, m/s
  std::array<double, 3> felt_{};          // N, behind the lag
  std::array<double, 3> seen_{}, velocity_seen_{};
};

}  // namespace mock
