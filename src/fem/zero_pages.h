#pragma once

#include <cstddef>

namespace bodkin {

// Asks for large pages (2 MiB) where these bytes, which nothing has been written to yet, span any: what is read here
// and there then needs no page looked up each time. Where that is not possible nothing is lost.
void prefer_large_pages(void* begin, std::size_t bytes) noexcept;

// Many numbers, all zero at first. The machine gives the pages when they are first written to, large ones (2 MiB)
// where it has them, and takes them back at the end.
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

}  // namespace bodkin
