#include "core/large_pages.h"

#include <sys/mman.h>

namespace bodkin {

void prefer_large_pages(void* begin, std::size_t bytes) noexcept {
  constexpr std::size_t page = 4096;  // madvise() wants whole ones
  std::size_t room = bytes;
  if (std::align(page, page, begin, room) != nullptr) madvise(begin, room / page * page, MADV_HUGEPAGE);
}

}  // namespace bodkin
