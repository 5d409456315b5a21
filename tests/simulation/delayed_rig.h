#pragma once

// The whole chain of a real device around a hand, like SafetyRig, with an independent device: its mass, damping,
// friction and delay are not derived from the stiffness to be rendered.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tests/haptics/device_model.h"
#include "tests/haptics/published_devices.h"
#include "tests/simulation/safety_rig.h"

#include "haptics/stable_stiffness.h"

namespace bodkin {

class DelayedRig {
 public:
  static constexpr double dt = 0.001;
  static constexpr double middle = 20.0;  // mm of depth in the middle of the workspace

  // `delay`: s, the device's true one, as 'devices calibrate' has measured it (`known`) or unknown to the guard.
  DelayedRig(const NamedResistance& resistance, const NamedConstraint& constraint, const PublishedDevice& published,
             double delay, bool known, std::uint64_t seed)
      : random(seed),
        abilities(offered(published, delay, known)),
        patient_(patient_on(resistance, constraint, abilities)),
        tissue_(patient_) {
    ServoSettings settings;
    settings.guard = guard_settings(abilities, 1000.0);
    settings.workspace.rotation = Eigen::AngleAxisd(std::acos(-1.0), Vec3::UnitX()).toRotationMatrix();
    settings.workspace.centre = Vec3(0.0, 0.0, middle);
    bound = HandGuard(settings.guard).bound();
    servo = std::make_unique<ServoTick>(
        settings,
        [this](const ControlInput& input) {
          return Control{tissue_.step({input.needle}).applied, 0.0};
        },
        TickClock{&no_time, nullptr});

    model.mass = random.uniform(0.05, 0.25);
    model.damping = 0.0001 * std::pow(50.0, random.uniform(0.0, 1.0));  // 0.1 to 5 N s/m
    model.friction = random.uniform(0.0, 0.1);
    model.resolution = abilities.resolution;
    model.hand_mass = random.uniform(0.03, 0.15);
    model.grip_stiffness = random.uniform(0.3, 3.0);
    model.grip_damping = random.uniform(0.002, 0.01);
    model.arm_stiffness = random.uniform(0.1, 0.6);
    model.arm_damping = random.uniform(0.002, 0.006);
    model.delay = delay;
    model.jitter = random.uniform(0.0, 0.0005);
    model.sent_with_next_tick = !abilities.owns_loop;
    aim(-5.0);
    model.put(target);
    state.hand.linear() = Eigen::AngleAxisd(std::acos(-1.0), Vec3::UnitX()).toRotationMatrix();
  }

  void aim(double depth, double x = 0.0, double y = 0.0) { target = Vec3(x, -y, middle - depth); }
  double depth() const { return middle - model.position.z(); }

  void tick() {
    model.step(target, dt);
    state.hand.translation() = model.reading() + Vec3(1e-7 * static_cast<double>(ticks % 2), 0.0, 0.0);
    applied = servo->step(state, dt);
    model.command(applied.force, random);
    ++ticks;
    GuardEvent event;
    while (servo->next_event(event)) ++counts[static_cast<std::size_t>(event.reason)];
  }
  bool is_safe() const {
    return applied.force.allFinite() && applied.force.norm() <= bound * (1.0 + 1e-9) && model.position.allFinite();
  }
  bool run(int count) {
    for (int i = 0; i < count; ++i) {
      tick();
      if (!is_safe()) return false;
    }
    return true;
  }
  void arm() {
    aim(-5.0);
    run(300);
    servo->command({.kind = ServoCommand::Kind::arm});
    run(1200);
  }
  int count(GuardReason reason) const { return counts[static_cast<std::size_t>(reason)]; }

  Random random;
  DeviceAbilities abilities;
  DeviceModel model;
  DeviceState state;
  Vec3 target = Vec3::Zero();
  Wrench applied;
  double bound = 0.0;
  std::unique_ptr<ServoTick> servo;
  std::array<int, static_cast<std::size_t>(GuardReason::count_of_reasons)> counts{};
  std::uint64_t ticks = 0;

 private:
  static DeviceAbilities offered(const PublishedDevice& published, double delay, bool known) {
    DeviceAbilities device;
    device.name = published.name;
    device.peak_force = published.peak;
    device.stiffness = published.stiffness;
    device.damping = published.damping;
    device.resolution = published.resolution;
    device.delay = published.delay;
    device.owns_loop = published.vendors_loop;
    if (known) device.measured_delay = delay;
    device.stiffness = stable_stiffness(device, 1000.0).weakest();
    return device;
  }

  Case patient_;
  HapticTick tissue_;
};

}  // namespace bodkin
