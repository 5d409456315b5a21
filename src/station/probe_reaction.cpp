#include "station/probe_reaction.h"

#include <algorithm>
#include <cmath>

#include "core/repeatable.h"

namespace bodkin::station {

namespace {

constexpr double firmest_spring = 1.0;     // N/mm; a hand feels no difference to more
constexpr double highest_reaction = 15.0;  // N, as of ProbeContact
constexpr double glide_time = 0.010;       // s
constexpr double contact_time = 0.020;     // s in which the force ramps up and down
constexpr double end_time = 0.3;           // s in which it fades when the probe no longer presses
constexpr double stiffness_margin = 1.5;   // a short step is made up for by the next one; a long one swings
constexpr double least_way = 0.5;          // mm, minimum of the way since contact, as a divisor
constexpr double least_step = 0.02;        // mm; larger ones carry information in the force
constexpr double forgetting = 0.98;        // share of the stiffness left after each step of the body

}  // namespace

ProbeReaction::ProbeReaction(double dt, double device_stiffness) noexcept
    : dt_(dt),
      stiffness_(std::min(firmest_spring, device_stiffness)),
      glide_(1.0 - repeatable::exp(-dt / glide_time)) {}

// From the whole displacement since contact and from its last increment; estimates decay slowly. A needle's hand also
// pushes while the probe is at rest, so its part carries no information about an increment.
void ProbeReaction::find_stiffness(const Vec3& axis, const fem::ProbeReading& reading) noexcept {
  const double force = reading.on_probe.force.norm();
  const double way = std::max(least_way, std::abs((reading.probe - met_).dot(axis)));
  const double step = std::abs((reading.probe - last_).dot(axis));
  body_ = std::max(forgetting * body_, stiffness_margin * force / way);
  const double of_press = (reading.on_probe.force - reading.by_needle.force).norm();
  if (step > least_step) body_ = std::max(body_, stiffness_margin * std::abs(of_press - last_force_) / step);
  last_ = reading.probe;
  last_force_ = of_press;
}

// Takes the result of a step of the body.
void ProbeReaction::take(const Vec3& hand, const Vec3& axis, const fem::ProbeReading& reading) noexcept {
  steps_ = reading.steps;
  glide_ = 1.0 - repeatable::exp(-dt_ / std::max(glide_time, waited_));
  waited_ = 0.0;
  if (!reading.on_probe.force.allFinite() || !reading.probe.allFinite()) return;
  const bool meets = reading.nodes > 0;
  if (meets && !touches_) {
    met_ = last_ = reading.probe;
    body_ = last_force_ = 0.0;
    if (share_ == 0.0) felt_ = hand;
    touches_ = true;
  }
  if (!meets && (hand - reading.probe).dot(axis) <= 0.0) touches_ = false;  // the hand has left the body
  if (!touches_) return;
  Vec3 push = Vec3::Zero();
  if (meets) {
    find_stiffness(axis, reading);
    push = reading.on_probe.force / stiffness_;
  }
  goal_ = reading.probe + (hand + push - reading.probe) / (1.0 + body_ / stiffness_);
}

Vec3 ProbeReaction::step(const Pose& hand, const fem::ProbeReading& reading, bool presses) noexcept {
  const Vec3 at = hand.translation(), axis = needle_axis(hand);
  waited_ += dt_;
  if (reading.steps != steps_) take(at, axis, reading);
  touches_ = touches_ && presses;
  if (touches_) {
    share_ = std::min(1.0, share_ + dt_ / contact_time);
    felt_ += glide_ * (goal_ - felt_);
  } else {
    share_ = std::max(0.0, share_ - dt_ / (presses ? contact_time : end_time));
  }
  probe_ = hand;
  if (touches_) probe_.translation() = goal_;
  const Vec3 spring = share_ * stiffness_ * (felt_ - at);
  force_ = share_ > 0.0 ? std::clamp(-spring.dot(axis), 0.0, highest_reaction) : 0.0;
  if (!(force_ > 0.0)) return Vec3::Zero();
  Vec3 sideways = spring - spring.dot(axis) * axis;
  const double drag = sideways.norm();
  if (drag > force_) sideways *= force_ / drag;
  return sideways - force_ * axis;
}

}  // namespace bodkin::station
