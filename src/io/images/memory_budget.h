#pragma once

#include <cstdint>

#include <sys/resource.h>

namespace bodkin::io {

// During its lifetime, the process may allocate at most `bytes` of additional writable memory; larger allocations
// fail with std::bad_alloc. For a library that trusts the lengths in a file before it has seen the bytes. Address
// space that is only reserved is free: a thread's heap reserves 64 MiB whenever it first has to wait for another's,
// which depends on the machine's load. Process-wide: for the image worker, which reads one file and does nothing
// else. No effect under the address sanitizer.
class MemoryBudget {
 public:
  explicit MemoryBudget(std::uint64_t bytes);
  ~MemoryBudget();
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

 private:
  rlimit before_{};
  bool set_ = false;
};

}  // namespace bodkin::io
