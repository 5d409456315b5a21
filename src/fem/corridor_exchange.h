#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "fem/condensed_body.h"
#include "fem/embedded_needle.h"

namespace bodkin {

// Hands newer and newer corridors of one body from the thread that makes them to the haptic thread. Three of them are
// in memory: one that the needle is in, one that is being made, and one between the two. Both ends are wait-free; the
// haptic end takes a new one by exchanging pointers, without copying, allocating or freeing anything.
//
// A needle keeps the corridor that it entered. The triangle of ContactFactor belongs to one compliance, and all of
// its constraints would have to be added anew for another: too long for a tick, and the force would jump. Therefore a
// new corridor is taken only while the needle touches nothing, when both have the same force: none.
class CorridorExchange {
 public:
  explicit CorridorExchange(const CondensedBody& first);

  // Maker only: the one to fill, of which the nodes stay as many and in the same order, and telling that it is
  // filled.
  CondensedBody& to_fill() noexcept { return slots_[making_]; }
  void publish() noexcept;

  // Haptic thread only. The corridor for EmbeddedNeedle, which may keep the reference: it stays at this address.
  const CondensedBody& body() const noexcept { return body_; }
  bool newer_waits() const noexcept { return (exchanged_.load(std::memory_order_relaxed) & fresh) != 0; }
  // Between two ticks, with what the last of them gave: puts the newest corridor into body() if there is a newer one
  // and the needle neither holds nor presses a node. True when it did; the needle must then begin() before its next
  // step. What it has punctured it remembers.
  bool take_newest(const EmbeddedNeedleForce& last) noexcept;

 private:
  static constexpr std::uint8_t slot_mask = 3;
  static constexpr std::uint8_t fresh = 4;

  CondensedBody body_;
  std::array<CondensedBody, 3> slots_;      // that of the haptic thread is an empty shell
  std::atomic<std::uint8_t> exchanged_{2};  // the slot between the two, and whether it is unread
  std::uint8_t making_ = 0;
  std::uint8_t shell_ = 1;
};

}  // namespace bodkin
