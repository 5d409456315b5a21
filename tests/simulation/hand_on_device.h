#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry.h"

namespace bodkin {

// A realistic hand that holds a device: mass, friction and damping of the mechanism, a hand that pulls with a spring
// and a damper towards its intended position, an encoder with counts, and a command that takes effect one tick after
// the reading it answers. Operator's frame, mm, s, N, kg.
struct HandOnDevice {
  double mass = 0.2;            // kg, handle and fingers
  double friction = 0.05;       // N
  double damping = 0.001;       // N s/mm, of the mechanism
  double hand_stiffness = 0.5;  // N/mm; 0 = let go
  double hand_damping = 0.003;  // N s/mm
  double strongest = 40.0;      // N, of the hand
  double resolution = 0.0;      // mm of one count; 0 = none

  Vec3 position = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();

  // One tick of `dt` under the device's force on the hand that was commanded in the tick before.
  void step(const Vec3& target, const Vec3& command, double dt) {
    constexpr int parts = 4;
    const double part = dt / parts;
    for (int i = 0; i < parts; ++i) {
      Vec3 pull = hand_stiffness * (target - position);
      if (pull.norm() > strongest) pull *= strongest / pull.norm();
      const double drag = damping + (hand_stiffness > 0.0 ? hand_damping : 0.0);
      const double per_newton = 1000.0 * part / mass;  // mm/s
      velocity = (velocity + per_newton * (pending_ + pull)) / (1.0 + per_newton * drag);
      const double speed = velocity.norm();
      if (speed > 0.0) velocity *= std::max(0.0, speed - per_newton * friction) / speed;
      position += part * velocity;
    }
    pending_ = command;
  }
  Vec3 reading() const {
    if (resolution <= 0.0) return position;
    return (position / resolution).array().round().matrix() * resolution;
  }

 private:
  Vec3 pending_ = Vec3::Zero();
};

}  // namespace bodkin
