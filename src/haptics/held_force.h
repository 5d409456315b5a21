#pragma once

#include <array>
#include <cstddef>

#include "core/geometry.h"

namespace bodkin::haptics {

// The force that a device actually holds while the hand moves. A command takes effect `delay` after it was sent, and
// is held until the next one does (a zero-order hold). A device in our own loop gets each command with the exchange
// of the next tick; a vendor's loop gets it at once. All functions are noexcept and allocate nothing.
class HeldForce {
 public:
  // `delay`: s from sending to the force at the hand, 0 to 0.02. `sent_with_next_tick`: the loop is ours.
  HeldForce(double delay, bool sent_with_next_tick) noexcept : delay_(delay), later_(sent_with_next_tick) {}

  // A tick begins, `dt` s (> 0) after the last one. Returns the mean, N, of the force held since then.
  Vec3 step(double dt) noexcept;
  // The command of the tick, N.
  void command(const Vec3& force) noexcept;

 private:
  static constexpr std::size_t capacity = 128;  // a power of two above 20 ms at 4 kHz

  struct Sent {
    Vec3 force = Vec3::Zero();
    double time = 0.0;  // s
  };

  void send(const Vec3& force) noexcept;

  double delay_;
  bool later_;
  double time_ = 0.0;  // s
  Vec3 waiting_ = Vec3::Zero();
  std::array<Sent, capacity> sent_{};
  std::size_t count_ = 0;
};

}  // namespace bodkin::haptics
