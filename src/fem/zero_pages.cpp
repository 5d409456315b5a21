#include "fem/zero_pages.h"

#include <string>
#include <utility>

#include <sys/mman.h>

#include "core/error.h"

namespace bodkin::fem {

ZeroPages::ZeroPages(std::size_t count) : bytes_(count * sizeof(double)) {
  if (bytes_ == 0) return;
  void* const pages = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) {
    throw SystemError("the machine refused " + std::to_string(bytes_) +
                      " bytes of memory; end other programs, or take a smaller body");
  }
  prefer_large_pages(pages, bytes_);
  numbers_ = static_cast<double*>(pages);
}

ZeroPages::~ZeroPages() {
  if (numbers_ != nullptr) munmap(numbers_, bytes_);
}

ZeroPages::ZeroPages(ZeroPages&& other) noexcept
    : numbers_(std::exchange(other.numbers_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}

ZeroPages& ZeroPages::operator=(ZeroPages&& other) noexcept {
  std::swap(numbers_, other.numbers_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

}  // namespace bodkin::fem
