#pragma once

#include <cstddef>

namespace bodkin {

// While one lives, every heap allocation, release and lock of this thread is counted. The test program defines malloc
// and its kin and pthread's lock functions itself, so nothing passes unseen, in whatever library it happens.
class RealTimeGuard {
 public:
  RealTimeGuard() noexcept;
  ~RealTimeGuard();
  RealTimeGuard(const RealTimeGuard&) = delete;
  RealTimeGuard& operator=(const RealTimeGuard&) = delete;

  static std::size_t heap_calls() noexcept;  // by this thread while guarded, since the last guard began
  static std::size_t lock_calls() noexcept;
  // False under a sanitizer, which needs these functions for itself.
  static bool available() noexcept;
};

// While one lives, no block of so many bytes or more is to be had, on any thread: where memory ends can be tested.
// RealTimeGuard::available() says whether this works.
class ScarceMemory {
 public:
  explicit ScarceMemory(std::size_t largest) noexcept;
  ~ScarceMemory();
  ScarceMemory(const ScarceMemory&) = delete;
  ScarceMemory& operator=(const ScarceMemory&) = delete;
};

}  // namespace bodkin
