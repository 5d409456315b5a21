#pragma once

#include <cstdint>

namespace bodkin::haptics {

// The clock with which a servo tick measures itself; no force depends on it. Simulated in tests.
struct TickClock {
  std::int64_t (*now)(void* user) noexcept = nullptr;  // ns, never backwards
  void* user = nullptr;

  std::int64_t operator()() const noexcept { return now(user); }
};

// The system's monotonic clock.
TickClock monotonic_clock() noexcept;
// The same clock in s.
double monotonic_seconds() noexcept;

// s; a longer pause between two ticks is treated as this.
inline constexpr double longest_dt = 1.0;

}  // namespace bodkin::haptics
