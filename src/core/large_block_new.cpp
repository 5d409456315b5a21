// The operator new of Bodkin's programs: it requests large pages for large blocks. A patient fills hundreds of
// megabytes, and a virtual machine may take longer to provide them page by page than a command computes. Libraries do
// not contain this file, because the allocation of a program is its own choice.
#include <algorithm>
#include <cstdlib>
#include <new>

#include "core/large_pages.h"

namespace {

constexpr std::size_t large = 2UL << 20U;  // bytes, of one large page

}  // namespace

void* operator new(std::size_t bytes) {
  for (;;) {
    void* const block = std::malloc(std::max<std::size_t>(bytes, 1));
    if (block != nullptr) {
      if (bytes >= large) bodkin::prefer_large_pages(block, bytes);
      return block;
    }
    const std::new_handler make_room = std::get_new_handler();
    if (make_room == nullptr) throw std::bad_alloc();
    make_room();
  }
}

void operator delete(void* block) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t /*bytes*/) noexcept {
  std::free(block);
}
