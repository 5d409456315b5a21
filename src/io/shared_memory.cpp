#include "io/shared_memory.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace bodkin::io {

SharedMemory::SharedMemory(const char* name) : descriptor_(memfd_create(name, MFD_CLOEXEC)) {
  if (descriptor_ < 0) throw SystemError(fmt::format("no shared memory: {}", std::strerror(errno)));
}

SharedMemory::~SharedMemory() {
  close(descriptor_);
}

std::size_t SharedMemory::size() const {
  struct stat status {};
  return fstat(descriptor_, &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

void SharedMemory::append(const void* source, std::size_t size) {
  const auto* place = static_cast<const char*>(source);
  while (size > 0) {
    const ssize_t count = ::write(descriptor_, place, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw SystemError(fmt::format("no shared memory: {}", std::strerror(errno)));
    place += count;
    size -= static_cast<std::size_t>(count);
  }
}

void SharedMemory::copy_to(void* target, std::size_t size, std::size_t offset) const {
  auto* place = static_cast<char*>(target);
  while (size > 0) {
    const ssize_t count = pread(descriptor_, place, size, static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw SystemError("shared memory ends too early");
    place += count;
    offset += static_cast<std::size_t>(count);
    size -= static_cast<std::size_t>(count);
  }
}

}  // namespace bodkin::io
