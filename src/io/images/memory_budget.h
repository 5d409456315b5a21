#pragma once

#include <cstdint>

#include <sys/resource.h>

namespace bodkin::io {

// While it lives, the process may take no more than `bytes` of writable memory beyond what it has; what wants more
// gets std::bad_alloc. For a library that believes the lengths in a file before it has seen the bytes. Address space
// that is only reserved is free: a thread's heap reserves 64 MiB whenever it first has to wait for another's, which
// depends on the machine's load. Process-wide: for the image worker, which reads one file and does nothing else. Does
// nothing under the address sanitizer.
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
