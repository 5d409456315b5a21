#include "io/images/memory_budget.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <unistd.h>

namespace bodkin::io {
namespace {

#ifdef BODKIN_ADDRESS_SANITIZER
constexpr bool limits_memory = false;  // the sanitizer maps terabytes that it never touches
#else
constexpr bool limits_memory = true;
#endif

// Bytes of private writable memory in use; 0 if unknown.
std::uint64_t in_use() {
  // Pages: size, resident, shared, text, library, data and stack.
  std::array<std::uint64_t, 6> pages{};
  std::ifstream statm("/proc/self/statm");
  for (std::uint64_t& count : pages) statm >> count;
  return pages.back() * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

MemoryBudget::MemoryBudget(std::uint64_t bytes) {
  if (!limits_memory) return;
  const std::uint64_t used = in_use();
  if (used == 0 || getrlimit(RLIMIT_DATA, &before_) != 0) return;
  rlimit narrow = before_;
  narrow.rlim_cur = std::min<rlim_t>(before_.rlim_cur, used + bytes);
  set_ = setrlimit(RLIMIT_DATA, &narrow) == 0;
}

MemoryBudget::~MemoryBudget() {
  if (set_) setrlimit(RLIMIT_DATA, &before_);
}

}  // namespace bodkin::io
