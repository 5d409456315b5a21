#pragma once

// The guard of a device around a wall, in a hand that holds the device: a closed loop without a clock.
#include <algorithm>
#include <array>
#include <functional>
#include <string>

#include "tests/haptics/device_model.h"

#include "haptics/guard_settings.h"
#include "haptics/hand_guard.h"

namespace bodkin {

using namespace bodkin::haptics;

struct HeldOnDevice {
  HeldOnDevice(const DeviceAbilities& device, const DeviceModel& in_hand, std::uint64_t seed = 1)
      : settings(guard_settings(device, 1000.0)), guard(settings), model(in_hand), random(seed) {
    model.sent_with_next_tick = !device.owns_loop;
    model.resolution = device.resolution;
  }

  // One tick: the hand's intended position is `target`, and `force` answers the reading.
  const Wrench& tick(const Vec3& target, const std::function<Vec3(const Vec3&)>& force) {
    model.step(target, 0.001);
    state.hand.translation() = model.reading() + Vec3(ticks++ % 2 == 0 ? 1e-7 : 0.0, 0.0, 0.0);
    const Wrench& applied =
        guard.step(state, {.wanted = {force(state.hand.translation()), Vec3::Zero()}, .dt = 0.001});
    for (const GuardEvent& event : guard.events()) {
      if (counts[static_cast<std::size_t>(event.reason)]++ == 0)
        first[static_cast<std::size_t>(event.reason)] = ticks;
    }
    model.command(applied.force, random);
    return applied;
  }
  // At rest `above` mm over the wall, with the whole force.
  void arm(double above = 5.0) {
    const auto nothing = [](const Vec3&) { return Vec3(Vec3::Zero()); };
    model.put({0.0, 0.0, above});
    for (int i = 0; i < 100; ++i) tick({0.0, 0.0, above}, nothing);
    guard.arm();
    for (int i = 0; i < 1200; ++i) tick({0.0, 0.0, above}, nothing);
  }
  int count(GuardReason reason) const { return counts[static_cast<std::size_t>(reason)]; }

  GuardSettings settings;
  HandGuard guard;
  DeviceModel model;
  Random random;
  DeviceState state;
  std::array<int, static_cast<std::size_t>(GuardReason::count_of_reasons)> counts{};
  std::array<long, static_cast<std::size_t>(GuardReason::count_of_reasons)> first{};  // tick of the first one
  long ticks = 0;
};

// A wall of `stiffness` (N/mm) below z = 0.
inline std::function<Vec3(const Vec3&)> wall_of(double stiffness) {
  return [stiffness](const Vec3& at) { return Vec3(0.0, 0.0, stiffness * std::max(0.0, -at.z())); };
}

// Turning points, each swing larger than `least`.
class TurningPoints {
 public:
  explicit TurningPoints(double least) : least_(least) {}
  void add(double place) {
    if (count_ < 0) extreme_ = place, count_ = 0;
    extreme_ = forwards_ ? std::max(extreme_, place) : std::min(extreme_, place);
    if (std::abs(place - extreme_) < least_) return;
    forwards_ = !forwards_;
    extreme_ = place;
    ++count_;
  }
  int count() const { return std::max(0, count_); }

 private:
  double least_, extreme_ = 0.0;
  bool forwards_ = true;
  int count_ = -1;
};

}  // namespace bodkin
