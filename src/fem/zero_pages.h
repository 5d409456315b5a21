#pragma once

#include <cstddef>

#include "core/large_pages.h"

namespace bodkin::fem {

// An array of numbers, initially zero, aligned to 64 bytes. The machine provides the pages of a large array when they
// are first written, large ones (2 MiB) where available, and reclaims them at the end.
class ZeroPages {
 public:
  ZeroPages() = default;
  // Throws SystemError when the allocation fails.
  explicit ZeroPages(std::size_t count);
  ~ZeroPages();
  ZeroPages(ZeroPages&& other) noexcept;
  ZeroPages& operator=(ZeroPages&& other) noexcept;
  ZeroPages(const ZeroPages&) = delete;
  ZeroPages& operator=(const ZeroPages&) = delete;

  double* data() const noexcept { return numbers_; }
  // The same memory as single-precision numbers, twice as many.
  float* singles() const noexcept { return reinterpret_cast<float*>(numbers_); }

 private:
  double* numbers_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace bodkin::fem
