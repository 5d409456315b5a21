#pragma once

#include <cstdint>

namespace bodkin::haptics {

// Where a servo tick reads the time that it measures itself with; no force depends on it. Virtual in tests.
struct TickClock {
  std::int64_t (*now)(void* user) noexcept = nullptr;  // ns, never backwards
  void* user = nullptr;

  std::int64_t operator()() const noexcept { return now(user); }
};

// The system's monotonic clock.
TickClock monotonic_clock() noexcept;
// The same, s.
double monotonic_seconds() noexcept;

// s; a longer pause between two ticks counts as this.
inline constexpr double longest_dt = 1.0;

}  // namespace bodkin::haptics
