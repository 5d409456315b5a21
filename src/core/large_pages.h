#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace bodkin {

// Requests large pages (2 MiB) for memory that has not been written to yet: the system then provides it in fewer
// steps, and scattered reads from it cost fewer page look-ups. Has no effect where large pages are not available.
void prefer_large_pages(void* begin, std::size_t bytes) noexcept;

// Allocator like std::allocator that requests large pages for blocks that span any.
template <typename T>
struct LargePageAllocator {
  using value_type = T;

  LargePageAllocator() = default;
  template <typename U>
  explicit(false) LargePageAllocator(const LargePageAllocator<U>& /*other*/) noexcept {}

  T* allocate(std::size_t count) {
    T* const begin = std::allocator<T>{}.allocate(count);
    prefer_large_pages(begin, count * sizeof(T));
    return begin;
  }
  void deallocate(T* begin, std::size_t count) noexcept { std::allocator<T>{}.deallocate(begin, count); }
  friend bool operator==(const LargePageAllocator&, const LargePageAllocator&) noexcept { return true; }
};

template <typename T>
using LargePageVector = std::vector<T, LargePageAllocator<T>>;

}  // namespace bodkin
