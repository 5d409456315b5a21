#pragma once

#include <algorithm>
#include <cmath>

#include "tests/simulation/model_pairs.h"

#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::simulation;

inline constexpr double deepest = 42.0;   // mm, in the epidural space of the slabs
inline constexpr double in_bone = 50.0;   // mm
inline constexpr double fastest = 150.0;  // mm/s
inline constexpr double stiffest = 4.2;   // N/mm: bone of `layered`, with a lateral spring beside it
inline constexpr double springs = 1.0;    // N/mm: stiffness of a purely elastic model together with a constraint

// A motor holds each force until the next one comes, and a spring without any loss then gives back K dx^2 / 2 a tick
// more than it took: 0.011 N mm at 150 mm/s and 1 N/mm. What leaves the governor, held like that, gives the hand no
// more than this and `least_held` on any way out of air and back.
inline constexpr double least_held = -1.0;  // N mm

struct Placement {
  Vec3 tip = Vec3(0.0, 0.0, -5.0);
  Vec3 tilt = Vec3::Zero();  // rad, about x and y

  TickInput input() const {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(tilt.norm(), tilt.norm() > 0.0 ? Vec3(tilt.normalized()) : Vec3(Vec3::UnitX()))
                        .toRotationMatrix();
    pose.translation() = tip;
    return {pose};
  }
};

// Plays placements into a tick and sums the work of the hand.
class Player {
 public:
  explicit Player(const Case& patient) : tick_(patient) {}

  const TickOutput& at(const Placement& placement) {
    const TickInput input = placement.input();
    const TickOutput next = tick_.step(input);
    const Vec3 moved = input.needle.translation() - last_.needle.translation();
    const Mat3 turned = input.needle.linear() * last_.needle.linear().transpose();
    const Eigen::AngleAxisd turn(turned);
    if (begun_) {
      const Wrench mean{0.5 * (next.requested.force + output_.requested.force),
                        0.5 * (next.requested.torque + output_.requested.torque)};
      work_ -= mean.force.dot(moved) + mean.torque.dot(turn.axis() * turn.angle());
      given_by_springs_ += 0.5 * springs * moved.squaredNorm();
      held_ -= output_.applied.force.dot(moved) + output_.applied.torque.dot(turn.axis() * turn.angle());
      // Where a force law has a corner inside a tick the trapezium rule errs by at most slope dx^2.
      const bool corner = moved.dot(way_) <= 0.0 || next.tissue != output_.tissue || next.events.size() > 0;
      if (corner) allowed_ += stiffest * moved.squaredNorm() + 1e-9;
    }
    begun_ = true;
    ++ticks_;
    way_ = moved;
    output_ = next;
    last_ = input;
    placement_ = placement;
    return output_;
  }
  // In a straight line at a speed (mm/s); a turn takes its time with it.
  void go(const Placement& to, double speed) {
    const Placement from = placement_;
    const double way = std::max((to.tip - from.tip).norm(), 200.0 * (to.tilt - from.tilt).norm());
    const int ticks = std::max(1, static_cast<int>(std::ceil(way / (speed * tick_.dt()))));
    for (int i = 1; i <= ticks; ++i) {
      const double part = static_cast<double>(i) / ticks;
      at({from.tip + part * (to.tip - from.tip), from.tilt + part * (to.tilt - from.tilt)});
    }
  }
  void rest(int ticks) {
    for (int i = 0; i < ticks; ++i) at(placement_);
  }
  void reset() {
    tick_.reset();
    begun_ = false;
    placement_ = {};
    ticks_ = 0;
  }
  void count_from_here() { work_ = allowed_ = held_ = given_by_springs_ = 0.0; }

  const Placement& placement() const { return placement_; }
  const TickOutput& output() const { return output_; }
  double work() const { return work_; }                          // N mm, done by the hand
  double given_by_springs() const { return given_by_springs_; }  // N mm, K dx^2 / 2 a tick
  double held() const { return held_; }  // N mm, the same against the applied force, each held over the next tick
  long ticks() const { return ticks_; }  // since the reset
  double allowed() const { return allowed_; }  // N mm, error of the sum

 private:
  HapticTick tick_;
  bool begun_ = false;
  long ticks_ = 0;
  TickInput last_;
  Vec3 way_ = Vec3::Zero();
  TickOutput output_;
  Placement placement_;
  double work_ = 0.0, allowed_ = 0.0, held_ = 0.0, given_by_springs_ = 0.0;
};

inline Placement straight(double depth) {
  return {Vec3(0.0, 0.0, depth), Vec3::Zero()};
}

}  // namespace bodkin
