#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace bodkin {

// Asks for large pages (2 MiB) where these bytes, which nothing has been written to yet, span any: what is read here
// and there then needs no page looked up each time. Where that is not possible nothing is lost.
void prefer_large_pages(void* begin, std::size_t bytes) noexcept;

// Gives memory as std::allocator does, on large pages where it spans any.
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
