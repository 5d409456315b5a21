#include "fem/zero_pages.h"

#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include <sys/mman.h>

#include "core/error.h"

namespace bodkin::fem {

namespace {

constexpr std::size_t cache_line = 64;                // bytes
constexpr std::size_t little = std::size_t{8} << 20;  // bytes: smaller ones the heap reuses without the system

double* pages_of_machine(std::size_t bytes) noexcept {
  void* const pages = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) return nullptr;
  prefer_large_pages(pages, bytes);
  return static_cast<double*>(pages);
}

double* zeros_of_heap(std::size_t bytes) noexcept {
  void* const numbers = std::aligned_alloc(cache_line, bytes);
  return static_cast<double*>(numbers == nullptr ? nullptr : std::memset(numbers, 0, bytes));
}

}  // namespace

ZeroPages::ZeroPages(std::size_t count)
    : bytes_((count * sizeof(double) + cache_line - 1) / cache_line * cache_line) {
  if (bytes_ == 0) return;
  numbers_ = bytes_ < little ? zeros_of_heap(bytes_) : pages_of_machine(bytes_);
  if (numbers_ == nullptr) {
    throw SystemError("the machine refused " + std::to_string(bytes_) +
                      " bytes of memory; end other programs, or take a smaller body");
  }
}

ZeroPages::~ZeroPages() {
  if (bytes_ < little)
    std::free(numbers_);
  else if (numbers_ != nullptr)
    munmap(numbers_, bytes_);
}

ZeroPages::ZeroPages(ZeroPages&& other) noexcept
    : numbers_(std::exchange(other.numbers_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}

ZeroPages& ZeroPages::operator=(ZeroPages&& other) noexcept {
  std::swap(numbers_, other.numbers_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

}  // namespace bodkin::fem
