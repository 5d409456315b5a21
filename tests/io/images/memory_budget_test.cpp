#include "io/images/memory_budget.h"

#include <memory_resource>
#include <new>

#include <gtest/gtest.h>
#include <sys/mman.h>

namespace bodkin {

using namespace bodkin::io;
namespace {

#ifndef BODKIN_ADDRESS_SANITIZER

void take(std::size_t bytes) {
  std::pmr::memory_resource& memory = *std::pmr::new_delete_resource();
  memory.deallocate(memory.allocate(bytes), bytes);
}

TEST(MemoryBudget, refuses_what_goes_beyond_it_and_only_while_it_lives) {
  constexpr std::size_t wanted = 512U << 20U;
  {
    const MemoryBudget budget(64U << 20U);
    EXPECT_NO_THROW(take(8U << 20U));
    EXPECT_THROW(take(wanted), std::bad_alloc);
  }
  EXPECT_NO_THROW(take(wanted));
}

// A second heap for a thread reserves address space at a moment that depends on the load of the machine; a budget
// that counted it sometimes refused sound files.
TEST(MemoryBudget, reserved_address_space_is_free) {
  const MemoryBudget budget(16U << 20U);
  constexpr std::size_t reserved = 512U << 20U;
  void* space = mmap(nullptr, reserved, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  ASSERT_NE(space, MAP_FAILED);
  EXPECT_NE(mprotect(space, reserved, PROT_READ | PROT_WRITE), 0) << "taking it is not";
  munmap(space, reserved);
}

#endif

}  // namespace
}  // namespace bodkin
