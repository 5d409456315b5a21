#pragma once

#include <string>
#include <vector>

#include "haptics/hand_guard.h"

namespace bodkin {

using namespace bodkin::haptics;

// A guard with a device that reports a hand at rest, with a minimal tremor.
struct GuardRig {
  explicit GuardRig(const GuardSettings& with = example()) : settings(with), guard(with) {}

  static GuardSettings example() {
    GuardSettings settings;
    settings.peak_force = 10.0;  // so 9 N
    settings.continuous_force = 3.0;
    settings.peak_torque = 200.0;  // so 180 N mm
    settings.workspace_low = Vec3::Constant(-80.0);
    settings.workspace_high = Vec3::Constant(80.0);
    return settings;
  }

  // One tick in which the simulation requests a force.
  const Wrench& tick(const Vec3& force, double age = 0.0, double dt = 0.001) {
    return tick(Wrench{force, Vec3::Zero()}, age, dt);
  }
  const Wrench& tick(const Wrench& wrench, double age = 0.0, double dt = 0.001) {
    if (alive) device.hand.translation().x() += (++ticks % 2 == 0 ? 1e-6 : -1e-6);
    const Wrench& applied = guard.step(device, {.wanted = wrench, .age = age, .dt = dt});
    for (const GuardEvent& event : guard.events()) events.push_back(event);
    return applied;
  }
  // Armed, ramped up, pushing with `force`.
  void push(const Vec3& force) {
    for (int i = 0; i < 60; ++i) tick(Vec3(Vec3::Zero()));
    guard.arm();
    for (int i = 0; i < 1100; ++i) tick(Vec3(Vec3::Zero()));
    for (int i = 0; i < 100; ++i) tick(force);
    events.clear();
  }
  // Ticks with `force` until the output is zero.
  int ticks_to_zero(const Vec3& force) {
    int count = 0;
    while (count < 1000) {
      ++count;
      if (tick(force).force.isZero(0.0)) break;
    }
    return count;
  }
  int count(GuardReason reason) const {
    int sum = 0;
    for (const GuardEvent& event : events) sum += event.reason == reason ? 1 : 0;
    return sum;
  }

  GuardSettings settings;
  HandGuard guard;
  DeviceState device;
  std::vector<GuardEvent> events;
  bool alive = true;
  int ticks = 0;
};

}  // namespace bodkin
