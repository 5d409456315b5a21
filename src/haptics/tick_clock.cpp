#include "haptics/tick_clock.h"

#include <ctime>

namespace bodkin::haptics {

namespace {

std::int64_t monotonic(void* /*user*/) noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

TickClock monotonic_clock() noexcept {
  return {&monotonic, nullptr};
}

double monotonic_seconds() noexcept {
  return static_cast<double>(monotonic(nullptr)) * 1e-9;
}

}  // namespace bodkin::haptics
