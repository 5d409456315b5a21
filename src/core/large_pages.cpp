#include "core/large_pages.h"

#include <cstdint>

#include <sys/mman.h>

namespace bodkin {

void prefer_large_pages(void* begin, std::size_t bytes) noexcept {
  constexpr std::uintptr_t page = 4096;  // madvise() requires whole ones; what others own there is not changed
  const std::uintptr_t before = reinterpret_cast<std::uintptr_t>(begin) % page;
  madvise(static_cast<std::byte*>(begin) - before, before + bytes, MADV_HUGEPAGE);
}

}  // namespace bodkin
