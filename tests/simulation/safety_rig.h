#pragma once

// The whole chain of a real device, around a hand on a simulated mechanism: HapticTick in a ServoTick with workspace
// and guard.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tests/simulation/hand_on_device.h"
#include "tests/simulation/model_pairs.h"

#include "core/error.h"
#include "core/random.h"
#include "haptics/device_profiles.h"
#include "haptics/servo_tick.h"
#include "io/device_profiles_file.h"
#include "simulation/haptic_tick.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::haptics;
using namespace bodkin::io;
using namespace bodkin::simulation;

// Every device of share/bodkin/devices.csv that is known to render a force.
inline std::vector<DeviceProfile> devices_with_force() {
  std::vector<DeviceProfile> found;
  for (const DeviceProfile& profile : default_device_profiles()) {
    if (profile.of(DeviceQuantity::peak_force).value > 0.0) found.push_back(profile);
  }
  return found;
}

// No spring of the case stiffer than the device renders: what the sentence that refuses the case asks its author to
// do.
inline void soften(Case& patient) {
  const double most = patient.description.device.stiffness;
  const auto bound = [most](double& stiffness) { stiffness = std::min(stiffness, most); };
  std::vector<TissueProperties> tissues = patient.library.tissues();
  for (TissueProperties& tissue : tissues) bound(tissue.tracking_wall.stiffness);
  patient.library = TissueLibrary(tissues);
  HapticSettings& haptics = patient.description.haptics;
  if (auto* depth_profile = std::get_if<DepthProfileSettings>(&haptics.resistance))
    bound(depth_profile->bone_stiffness);
  if (auto* parts = std::get_if<ThreeComponentSettings>(&haptics.resistance)) bound(parts->cutting_stiffness);
  // Its damper takes of what the device renders, too: half of what the spring leaves, in a period.
  if (auto* wall = std::get_if<SpringDamperWallSettings>(&haptics.resistance))
    wall->stiffness = std::min(wall->stiffness, most - 2.0 * wall->damping * haptics.rate);
  if (auto* fracture = std::get_if<FractureSettings>(&haptics.resistance)) {
    bound(fracture->cutting_stiffness);
    // The stiffness at which the membrane tears follows from k, and is about ten times as large.
    fracture->stiffness = std::min(fracture->stiffness, 0.08 * most);
  }
  if (auto* beam = std::get_if<BeamSettings>(&haptics.constraint)) bound(beam->largest_stiffness);
}

inline Case patient_on(const NamedResistance& resistance, const NamedConstraint& constraint,
                       const DeviceAbilities& device) {
  Case patient = patient_for(resistance, constraint);
  DeviceLimits& limits = patient.description.device;
  limits.profile = device.name;
  limits.peak_force = device.peak_force;
  limits.continuous_force = guard_settings(device, 1000.0).continuous_force;
  limits.peak_torque = device.peak_torque;
  limits.stiffness = device.stiffness > 0.0 ? device.stiffness : 1.0;
  limits.position_resolution = device.resolution;
  soften(patient);
  return patient;
}

inline std::int64_t no_time(void* /*user*/) noexcept {
  return 0;
}

class SafetyRig {
 public:
  static constexpr double dt = 0.001;
  static constexpr double middle = 20.0;  // mm of depth in the middle of the workspace

  // Throws InputError where the case is refused for this device.
  SafetyRig(const NamedResistance& resistance, const NamedConstraint& constraint, const DeviceProfile& profile,
            std::uint64_t seed)
      : abilities(abilities_of(profile)),
        random(seed),
        patient_(patient_on(resistance, constraint, abilities)),
        tissue_(patient_) {
    ServoSettings settings;
    settings.guard = guard_settings(abilities, 1000.0);
    settings.workspace.rotation = Eigen::AngleAxisd(std::acos(-1.0), Vec3::UnitX()).toRotationMatrix();
    settings.workspace.centre = Vec3(0.0, 0.0, middle);
    bound = HandGuard(settings.guard).bound();
    slew = settings.guard.slew;
    servo = std::make_unique<ServoTick>(
        settings,
        [this](const ControlInput& input) {
          if (controller) return controller(input);
          const TickOutput output = tissue_.step({input.needle});
          for (const Event& event : output.events) given_way += event.kind == EventKind::puncture ? 1 : 0;
          return Control{output.applied, 0.0};
        },
        TickClock{&no_time, nullptr});

    // A device that renders the stiffness K stably with the delay it has: b = K (T/2 + T).
    hand.damping = 1.5 * patient_.description.device.stiffness * dt;
    hand.friction = profile.of(DeviceQuantity::friction).value > 0.0 ? profile.of(DeviceQuantity::friction).value
                                                                     : random.uniform(0.03, 0.1);
    hand.mass = random.uniform(0.10, 0.30);
    hand.hand_stiffness = random.uniform(0.1, 0.6);
    hand.hand_damping = random.uniform(0.001, 0.005);
    hand.resolution = abilities.resolution;
    aim(-5.0);
    hand.position = target;
    device.hand.linear() = Eigen::AngleAxisd(std::acos(-1.0), Vec3::UnitX()).toRotationMatrix();
  }

  // The hand's intended position: depth and across, mm in the patient.
  void aim(double depth, double x = 0.0, double y = 0.0) { target = Vec3(x, -y, middle - depth); }
  double depth() const { return middle - hand.position.z(); }

  // One tick of everything.
  const Wrench& tick(double period = dt) {
    for (double passed = 0.0; passed < period - 1e-9; passed += dt) hand.step(target, applied.force, dt);
    const Mat3 straight = Eigen::AngleAxisd(std::acos(-1.0), Vec3::UnitX()).toRotationMatrix();
    device.hand.translation() = hand.reading() + Vec3(1e-7 * static_cast<double>(ticks % 2), 0.0, 0.0);
    device.hand.linear() = Eigen::AngleAxisd(tilt, Vec3::UnitX()).toRotationMatrix() * straight;
    if (spoil) spoil(device);
    before = applied;
    applied = servo->step(device, period);
    ++ticks;
    GuardEvent event;
    while (servo->next_event(event)) {
      ++counts[static_cast<std::size_t>(event.reason)];
      last_event = event;
    }
    return applied;
  }
  bool run(int count) {
    for (int i = 0; i < count; ++i) {
      tick();
      if (!is_safe()) return false;
    }
    return true;
  }
  // Outside, at rest, armed.
  bool arm(bool whole_force = false) {
    aim(-5.0);
    if (!run(400)) return false;
    servo->command({.kind = ServoCommand::Kind::arm});
    return run(whole_force ? 1150 : 100);
  }

  // Finite, within the device's limits, and no faster up than the slew.
  bool is_safe() const {
    if (!applied.force.allFinite() || !applied.torque.allFinite()) return false;
    if (applied.force.norm() > bound * (1.0 + 1e-9) || bound > 0.9 * abilities.peak_force * (1.0 + 1e-12))
      return false;
    if (applied.torque.norm() > abilities.peak_torque * (1.0 + 1e-9)) return false;
    const double square = before.force.squaredNorm();
    const double kept = square > 0.0 ? std::clamp(applied.force.dot(before.force) / square, 0.0, 1.0) : 0.0;
    return (applied.force - kept * before.force).norm() <= slew * 2.0 * dt + 1e-9;
  }
  GuardState state() { return servo->snapshot().state; }
  int count(GuardReason reason) const { return counts[static_cast<std::size_t>(reason)]; }

  DeviceAbilities abilities;
  Random random;
  HandOnDevice hand;
  DeviceState device;
  std::function<void(DeviceState&)> spoil;                 // what the device reports wrongly
  std::function<Control(const ControlInput&)> controller;  // instead of the tissue
  Vec3 target = Vec3::Zero();
  double tilt = 0.0;  // rad
  Wrench applied, before;
  double bound = 0.0;  // N
  double slew = 0.0;   // N/s
  std::unique_ptr<ServoTick> servo;
  std::array<int, static_cast<std::size_t>(GuardReason::count_of_reasons)> counts{};
  GuardEvent last_event;
  std::uint64_t ticks = 0;
  int given_way = 0;  // tissues that were punctured

 private:
  Case patient_;
  HapticTick tissue_;
};

}  // namespace bodkin
