#include "haptics/simulated_hand.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "core/repeatable.h"
#include "core/rotation.h"
#include "core/settings_check.h"

namespace bodkin::haptics {

namespace {

// 1 N = 1000 kg mm/s^2.
constexpr double per_newton = 1000.0;
constexpr double least_stiffness = 0.05, most_stiffness = 20.0;  // N/mm
constexpr double most_damping = 1.0;                             // N s/mm

Pose turned(const Vec3& turn, const Pose& pose) noexcept {
  Pose result = pose;
  const double angle = turn.norm();
  if (angle > 1e-12) result.linear() = rotation_about(turn / angle, angle) * pose.linear();
  return result;
}

}  // namespace

void check(const HandParameters& parameters) {
  constexpr auto origin = "simulated hand";
  check_range(origin, "mass", parameters.mass, {0.02, 5.0}, "kg");
  check_range(origin, "stiffness", parameters.stiffness, {least_stiffness, most_stiffness}, "N/mm");
  check_range(origin, "damping", parameters.damping, {0.0, most_damping}, "N s/mm");
  check_range(origin, "inertia", parameters.inertia, {10.0, 1e5}, "kg mm^2");
  check_range(origin, "rotation stiffness", parameters.rotation_stiffness, {10.0, 1e6}, "N mm/rad");
  check_range(origin, "rotation damping", parameters.rotation_damping, {0.0, 1e5}, "N mm s/rad");
  check_range(origin, "tremor", parameters.tremor, {0.0, 5.0}, "mm");
  check_range(origin, "tremor of the angle", parameters.tremor_angle, {0.0, 0.2}, "rad");
}

SimulatedHand::SimulatedHand(const HandParameters& parameters, double dt, std::uint64_t seed)
    : parameters_((check(parameters), parameters)),
      dt_(dt),
      translation_(
          transition(parameters.mass, parameters.stiffness * per_newton, parameters.damping * per_newton, dt)),
      rotation_(transition(parameters.inertia, parameters.rotation_stiffness * per_newton,
                           parameters.rotation_damping * per_newton, dt)),
      tremor_(parameters.tremor, dt, mix64(seed)),
      tremor_angle_(parameters.tremor_angle, dt, mix64(mix64(seed))) {}

// z'' + (c/m) z' + (k/m) z = 0 over one tick, in closed form for light, critical and heavy damping.
SimulatedHand::Transition SimulatedHand::transition(double mass, double stiffness, double damping, double dt) {
  const double decay = damping / (2.0 * mass);
  const double square = stiffness / mass;
  const double discriminant = decay * decay - square;
  const double root = std::sqrt(std::abs(discriminant));
  double even = 1.0, odd = dt;  // critical damping
  if (root * dt > 1e-9) {
    even = discriminant > 0.0 ? repeatable::cosh(root * dt) : repeatable::cos(root * dt);
    odd = (discriminant > 0.0 ? repeatable::sinh(root * dt) : repeatable::sin(root * dt)) / root;
  }
  const double fade = repeatable::exp(-decay * dt);
  return {fade * (even + decay * odd), fade * odd, -fade * square * odd, fade * (even - decay * odd)};
}

void SimulatedHand::set_grip(double stiffness, double damping, const Vec3& intended) noexcept {
  parameters_.stiffness = std::clamp(stiffness, least_stiffness, most_stiffness);
  parameters_.damping = std::clamp(damping, 0.0, most_damping);
  translation_ =
      transition(parameters_.mass, parameters_.stiffness * per_newton, parameters_.damping * per_newton, dt_);
  intended_ = intended;
}

void SimulatedHand::start(const Pose& pose) noexcept {
  needle_ = pose;
  intended_ = pose.translation();
  velocity_.setZero();
  turn_.setZero();
  turn_rate_.setZero();
}

const Pose& SimulatedHand::step(const Pose& intended, const Wrench& on_hand) noexcept {
  const Vec3 goal = intended.translation() + tremor_.next();
  const Vec3 pace = (goal - intended_) / dt_;
  const Vec3 rest = on_hand.force / parameters_.stiffness;  // where the spring alone would balance the force
  const Vec3 offset = needle_.translation() - intended_ - rest;
  const Vec3 rate = velocity_ - pace;
  const Vec3 tip = goal + rest + translation_.xx * offset + translation_.xv * rate;
  velocity_ = pace + translation_.vx * offset + translation_.vv * rate;
  intended_ = goal;

  const Vec3 turn_rest = on_hand.torque / parameters_.rotation_stiffness;
  const Vec3 turn_offset = turn_ - turn_rest;
  turn_ = turn_rest + rotation_.xx * turn_offset + rotation_.xv * turn_rate_;
  turn_rate_ = rotation_.vx * turn_offset + rotation_.vv * turn_rate_;

  needle_ = turned(turn_ + tremor_angle_.next(), intended);
  needle_.translation() = tip;
  return needle_;
}

}  // namespace bodkin::haptics
