#pragma once

// A haptic device in a hand, as a model independent of the guard: its properties are not derived from the stiffness
// to be rendered.
#include <algorithm>
#include <cmath>
#include <deque>

#include "core/geometry.h"
#include "core/random.h"

namespace bodkin {

// The device is a mass with viscous and dry friction; the hand a mass that holds it by a grip and hangs on an arm
// that pulls to the intended position. The motors hold each force until the next one arrives (zero-order hold), each
// `delay` plus up to `jitter` late, never out of order. Operator's frame, mm, s, N, kg.
struct DeviceModel {
  double mass = 0.1;                // kg, of the device at its handle
  double damping = 0.001;           // N s/mm, its own
  double friction = 0.05;           // N, dry
  double resolution = 0.0;          // mm of one count; 0 = none
  double hand_mass = 0.1;           // kg
  double grip_stiffness = 1.0;      // N/mm; 0 = the handle is let go
  double grip_damping = 0.004;      // N s/mm
  double arm_stiffness = 0.3;       // N/mm
  double arm_damping = 0.003;       // N s/mm
  double delay = 0.0;               // s from sending to the force at the handle
  double jitter = 0.0;              // s
  bool sent_with_next_tick = true;  // the loop is Bodkin's

  Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
  Vec3 hand_position = Vec3::Zero(), hand_velocity = Vec3::Zero();
  Vec3 given = Vec3::Zero();  // N mm that the motors have given to the handle, by axis: the truth

  void put(const Vec3& place) {
    position = hand_position = place;
    velocity.setZero();
    hand_velocity.setZero();
  }

  // The tick's answer to the last reading.
  void command(const Vec3& force, Random& random) {
    if (sent_with_next_tick) std::swap(waiting_, next_);
    next_ = force;
    send(sent_with_next_tick ? waiting_ : force, random);
  }
  // Until the next reading, `dt` later.
  void step(const Vec3& target, double dt) {
    constexpr int parts = 20;
    const double part = dt / parts;
    for (int i = 0; i < parts; ++i) {
      time_ += part;
      while (!in_transit_.empty() && in_transit_.front().at <= time_ - 0.5 * part) {
        force_ = in_transit_.front().force;
        in_transit_.pop_front();
      }
      const Vec3 grip =
          grip_stiffness > 0.0
              ? Vec3(grip_stiffness * (hand_position - position) + grip_damping * (hand_velocity - velocity))
              : Vec3(Vec3::Zero());
      const Vec3 arm = arm_stiffness * (target - hand_position) - arm_damping * hand_velocity;
      const double per_newton = 1000.0 * part / mass;  // mm/s
      velocity = (velocity + per_newton * (force_ + grip)) / (1.0 + per_newton * damping);
      const double speed = velocity.norm();
      if (speed > 0.0) velocity *= std::max(0.0, speed - per_newton * friction) / speed;
      hand_velocity += 1000.0 * part / hand_mass * (arm - grip);
      position += part * velocity;
      hand_position += part * hand_velocity;
      given += part * force_.cwiseProduct(velocity);
    }
  }
  Vec3 reading() const {
    if (resolution <= 0.0) return position;
    return (position / resolution).array().round().matrix() * resolution;
  }
  const Vec3& force() const { return force_; }

 private:
  struct ForceInTransit {
    double at = 0.0;
    Vec3 force = Vec3::Zero();
  };

  void send(const Vec3& force, Random& random) {
    double at = time_ + delay + (jitter > 0.0 ? random.uniform(0.0, jitter) : 0.0);
    if (!in_transit_.empty()) at = std::max(at, in_transit_.back().at);
    in_transit_.push_back({at, force});
  }

  double time_ = 0.0;
  Vec3 force_ = Vec3::Zero(), waiting_ = Vec3::Zero(), next_ = Vec3::Zero();
  std::deque<ForceInTransit> in_transit_;
};

}  // namespace bodkin
