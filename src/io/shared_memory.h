#pragma once

#include <cstddef>

namespace bodkin::io {

// An unnamed file in memory through which this process and a worker exchange data. Throws SystemError when memory is
// short.
class SharedMemory {
 public:
  explicit SharedMemory(const char* name);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  int descriptor() const { return descriptor_; }
  std::size_t size() const;  // bytes
  // Appends `size` bytes.
  void append(const void* source, std::size_t size);
  // Copies `size` bytes from `offset`; they must be there.
  void copy_to(void* target, std::size_t size, std::size_t offset = 0) const;

 private:
  int descriptor_;
};

}  // namespace bodkin::io
