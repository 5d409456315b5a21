#pragma once

#include <array>
#include <cstdint>

#include "core/geometry.h"
#include "haptics/tremor.h"

namespace bodkin::haptics {

// A hand and forearm that hold the needle: at the tip a mass on a spring and a damper whose other end is the intended
// position of the needle (the equilibrium point set by the muscles). The needle's rotation yields to torques by the
// same law.
//
//   m x'' = F + k (p - x) + c (p' - x')        F: force of the device on the hand, p: intended tip position
//   J w'' = T - k_r w - c_r w'                 T: torque about the tip, w: rotation from the intended one
//
// A precision grip is near m = 0.1 to 0.4 kg, k = 0.3 to 1 N/mm when relaxed and several times that when the hand is
// braced against the patient's back.
struct HandParameters {
  double mass = 0.3;                   // m, kg, moving with the tip; 0.02 to 5
  double stiffness = 2.0;              // k, N/mm; 0.05 to 20
  double damping = 0.04;               // c, N s/mm; 0 to 1
  double inertia = 400.0;              // J, kg mm^2; 10 to 1e5
  double rotation_stiffness = 4000.0;  // k_r, N mm/rad; 10 to 1e6
  double rotation_damping = 56.0;      // c_r, N mm s/rad; 0 to 1e5
  double tremor = 0.0;                 // mm, root mean square of the intended position along each axis; 0 to 5
  double tremor_angle = 0.0;           // rad, the same of the orientation; 0 to 0.2
};

// Throws InputError naming the first parameter outside its range.
void check(const HandParameters& parameters);

// The hand over time. Each step solves the equations above exactly for a force that is constant and an intention that
// moves uniformly during the tick, so the hand can neither gain energy from the step nor diverge, however stiff it
// is.
class SimulatedHand {
 public:
  // `dt`: s. Equal seeds give equal tremor. Throws InputError for parameters out of range.
  SimulatedHand(const HandParameters& parameters, double dt, std::uint64_t seed);

  // Starts at rest at `pose`, which is also the intended pose.
  void start(const Pose& pose) noexcept;
  // One tick under the device's wrench (on the hand, LPS, about the tip). The translation follows `intended` through
  // the dynamics; its orientation takes effect at once, so the caller turns it at a human pace. Returns the needle's
  // pose.
  const Pose& step(const Pose& intended, const Wrench& on_hand) noexcept;

  // Changes the grip: k and c, within the ranges of HandParameters (clamped), and the intended position of the tip,
  // `intended`; nothing moves.
  void set_grip(double stiffness, double damping, const Vec3& intended) noexcept;

  const Pose& needle() const noexcept { return needle_; }
  // mm/s, of the tip.
  const Vec3& velocity() const noexcept { return velocity_; }

 private:
  // Displacement and velocity at the end of a tick as functions of those at its start, without force.
  struct Transition {
    double xx, xv, vx, vv;
  };
  static Transition transition(double mass, double stiffness, double damping, double dt);

  HandParameters parameters_;
  double dt_;
  Transition translation_;
  Transition rotation_;
  Tremor tremor_;
  Tremor tremor_angle_;
  Pose needle_ = Pose::Identity();
  Vec3 intended_ = Vec3::Zero();  // mm, with tremor, at the end of the last tick
  Vec3 velocity_ = Vec3::Zero();
  Vec3 turn_ = Vec3::Zero();  // w, rad
  Vec3 turn_rate_ = Vec3::Zero();
};

}  // namespace bodkin::haptics
