#include "haptics/guard_settings.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/error.h"

namespace bodkin::haptics {

namespace {

constexpr double unknown_continuous = 0.15;  // of the peak
constexpr double counts_of_a_swing = 1.9;    // of the encoder: one count is noise, two are a swing

void require_of_device(bool holds, const char* what, double value, const char* expected) {
  if (holds) return;
  std::ostringstream text;
  text << "device: " << what << " is " << value << ", expected " << expected << "; correct the device's profile";
  throw InputError(text.str());
}

bool positive(double value) {
  return value > 0.0 && std::isfinite(value);
}

}  // namespace

GuardSettings guard_settings(const DeviceAbilities& abilities, double rate) {
  GuardSettings settings;
  settings.dt = 1.0 / rate;
  settings.peak_force = abilities.peak_force;
  settings.continuous_force =
      abilities.continuous_force > 0.0 ? abilities.continuous_force : unknown_continuous * abilities.peak_force;
  settings.peak_torque = abilities.peak_torque;
  settings.workspace_low = abilities.workspace_low;
  settings.workspace_high = abilities.workspace_high;
  if (abilities.stiffness > 0.0) settings.stiffness = abilities.stiffness;
  // Twice what a wall of the device's own stiffness leaks by being sampled is enough for whatever it renders stably.
  settings.damping =
      abilities.damping > 0.0 ? abilities.damping : std::min(settings.damping, settings.stiffness * settings.dt);
  settings.oscillation_amplitude = std::max(settings.oscillation_amplitude, counts_of_a_swing * abilities.resolution);
  return settings;
}

void check(const GuardSettings& settings) {
  require_of_device(settings.dt >= 0.00025 && settings.dt <= 0.005, "the period", settings.dt, "0.00025 to 0.005 s");
  require_of_device(settings.peak_force >= 0.0 && std::isfinite(settings.peak_force), "the peak force",
                    settings.peak_force, "0 N or more");
  require_of_device(settings.peak_force == 0.0 || positive(settings.continuous_force), "the continuous force",
                    settings.continuous_force, "more than 0 N");
  require_of_device(settings.continuous_force <= settings.peak_force, "the continuous force",
                    settings.continuous_force, "at most the peak force");
  require_of_device(settings.peak_torque >= 0.0 && std::isfinite(settings.peak_torque), "the peak torque",
                    settings.peak_torque, "0 N mm or more");
  require_of_device(settings.user_force >= 0.0, "the user's limit", settings.user_force, "0 N or more");
  const Vec3 size = settings.workspace_high - settings.workspace_low;
  const bool unknown = settings.workspace_high.isZero(0.0) && settings.workspace_low.isZero(0.0);
  require_of_device(size.allFinite() && (unknown || size.minCoeff() > 0.0), "the workspace's smallest side",
                    size.minCoeff(), "more than 0 mm");
  require_of_device(positive(settings.slew), "the slew", settings.slew, "more than 0 N/s");
  require_of_device(positive(settings.torque_slew), "the slew of the torque", settings.torque_slew,
                    "more than 0 N mm/s");
  require_of_device(positive(settings.ramp_time), "the ramp", settings.ramp_time, "more than 0 s");
  require_of_device(settings.fade_time > 0.0 && settings.fade_time <= 0.020, "the fade", settings.fade_time,
                    "more than 0 and at most 0.02 s");
  require_of_device(settings.arming_force >= 0.0, "the force at arming", settings.arming_force, "0 N or more");
  require_of_device(positive(settings.arming_patience), "the patience at arming", settings.arming_patience,
                    "more than 0 s");
  require_of_device(positive(settings.speed_limit), "the speed limit", settings.speed_limit, "more than 0 mm/s");
  require_of_device(settings.frozen_time >= 0.0, "the time of unchanged readings", settings.frozen_time,
                    "0 s or more");
  require_of_device(positive(settings.oscillation_amplitude), "the amplitude of a shake",
                    settings.oscillation_amplitude, "more than 0 mm");
  require_of_device(positive(settings.stiffness), "the stiffness", settings.stiffness, "more than 0 N/mm");
  require_of_device(positive(settings.thermal_time), "the thermal time", settings.thermal_time, "more than 0 s");
}

}  // namespace bodkin::haptics
