#include "haptics/guard_settings.h"

#include <algorithm>

namespace bodkin::haptics {

namespace {

constexpr double unknown_continuous = 0.15;  // of the peak
constexpr double counts_of_a_swing = 1.9;    // of the encoder: one count is noise, two are a swing

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
  // Twice the energy that sampling a wall of the device's own stiffness generates suffices for any stable rendering.
  settings.damping =
      abilities.damping > 0.0 ? abilities.damping : std::min(settings.damping, settings.stiffness * settings.dt);
  settings.delay = abilities.measured_delay.value_or(abilities.delay);
  settings.sent_with_next_tick = !abilities.owns_loop;
  settings.damping *= 2.0 * settings.dt / (2.0 * settings.dt + settings.delay);
  settings.oscillation_amplitude = std::max(settings.oscillation_amplitude, counts_of_a_swing * abilities.resolution);
  return settings;
}

}  // namespace bodkin::haptics
