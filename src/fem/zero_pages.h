#pragma once

#include <cstddef>

#include "core/large_pages.h"

namespace bodkin::fem {

// Many numbers, all zero at first, at a multiple of 64 bytes. Where they are many the machine gives the pages when
// they are first written to, large ones (2 MiB) where it has them, and takes them back at the end.
class ZeroPages {
 public:
  ZeroPages() = default;
  // Throws SystemError when the machine refuses.
  explicit ZeroPages(std::size_t count);
  ~ZeroPages();
  ZeroPages(ZeroPages&& other) noexcept;
  ZeroPages& operator=(ZeroPages&& other) noexcept;
  ZeroPages(const ZeroPages&) = delete;
  ZeroPages& operator=(const ZeroPages&) = delete;

  double* data() const noexcept { return numbers_; }
  // The same memory for numbers of single precision, twice as many.
  float* singles() const noexcept { return reinterpret_cast<float*>(numbers_); }

 private:
  double* numbers_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace bodkin::fem
