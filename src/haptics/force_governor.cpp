#include "haptics/force_governor.h"

#include <algorithm>
#include <cmath>

#include "haptics/force_change.h"

namespace bodkin::haptics {

namespace {

// One tick of the linear ramp to zero.
Vec3 fade(const Vec3& last, const Vec3& step) noexcept {
  return last.squaredNorm() > step.squaredNorm() ? Vec3(last - step) : Vec3::Zero();
}

}  // namespace

ForceGovernor::ForceGovernor(const GovernorSettings& settings)
    : settings_(settings),
      passivity_(settings.dt, settings.damping_limit, settings.peak_force, settings.velocity_threshold) {}

void ForceGovernor::reset() noexcept {
  passivity_.reset();
  applied_.setZero();
  torque_.setZero();
  mean_square_ = 0.0;
  flags_ = 0;
  ramping_ = true;
  failed_ = false;
}

void ForceGovernor::fail() noexcept {
  if (failed_) return;
  failed_ = true;
  fade_step_ = applied_ * std::min(1.0, settings_.dt / settings_.fade);
  fade_turn_ = torque_ * std::min(1.0, settings_.dt / settings_.fade);
}

Vec3 ForceGovernor::limit_slew(const Vec3& wanted) noexcept {
  const ForceChange change =
      approach(applied_, wanted, (ramping_ ? settings_.ramp_slew : settings_.slew) * settings_.dt);
  if (change.limited) {
    flags_ |= ramping_ ? force_limit::slew | force_limit::ramp : force_limit::slew;
  } else {
    ramping_ = false;  // the force has caught up with what is asked for
  }
  return change.value;
}

// Called after the force, whose faults also apply to the torque.
void ForceGovernor::step_torque(const Vec3& wanted) noexcept {
  if (!failed_ && !(wanted.allFinite() && std::isfinite(wanted.squaredNorm()))) {
    fail();
    flags_ |= force_limit::fault;
  }
  if (failed_) {
    torque_ = fade(torque_, fade_turn_);
    return;
  }
  const ForceChange change = approach(torque_, wanted, settings_.torque_slew * (ramping_ ? 0.1 : 1.0) * settings_.dt);
  if (change.limited) flags_ |= force_limit::slew;
  torque_ = settings_.peak_torque > 0.0 ? limit_size(change.value, settings_.peak_torque, force_limit::peak)
                                        : Vec3(Vec3::Zero());  // lacking torques is no fault
}

Vec3 ForceGovernor::limit_size(const Vec3& force, double size, std::uint8_t flag) noexcept {
  const ForceChange change = shortened(force, size);
  if (change.limited) flags_ |= flag;
  return change.value;
}

Vec3 ForceGovernor::step(const ForceRequest& request) noexcept {
  flags_ = 0;
  Vec3 force = applied_;
  if (!failed_) {
    const double resistance = passivity_.step(request.resistance, request.velocity, request.in_contact);
    if (passivity_.damping() > 0.0) flags_ |= force_limit::passivity;
    const Vec3 wanted = request.constraint - resistance * request.axis + request.compensation;
    if (wanted.allFinite() && std::isfinite(wanted.squaredNorm())) {
      force = limit_slew(wanted);
    } else {
      fail();
    }
  }
  if (failed_) {
    flags_ |= force_limit::fault;
    force = fade(applied_, fade_step_);
  }
  force = limit_size(force, settings_.peak_force, force_limit::peak);
  force = limit_size(force, thermal_bound(mean_square_, settings_.continuous_force, settings_.peak_force),
                     force_limit::thermal);
  mean_square_ += settings_.dt / settings_.thermal_time * (force.squaredNorm() - mean_square_);
  applied_ = force;
  step_torque(request.torque);
  return force;
}

}  // namespace bodkin::haptics
