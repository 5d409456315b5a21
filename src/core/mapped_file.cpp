#include "core/mapped_file.h"

#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

namespace bodkin {

MappedFile::MappedFile(const std::filesystem::path& file) {
  const int handle = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe would wait for its other end
  struct stat about {};
  if (handle < 0 || fstat(handle, &about) != 0 || !S_ISREG(about.st_mode)) {
    if (handle >= 0) close(handle);
    throw InputError(file.string() + " cannot be opened; is it a file, is it there, and may you read it?");
  }
  size_ = static_cast<std::size_t>(about.st_size);
  void* pages = nullptr;
  if (size_ > 0) pages = mmap(nullptr, size_, PROT_READ, MAP_SHARED | MAP_POPULATE, handle, 0);
  close(handle);
  if (pages == MAP_FAILED) throw InputError(file.string() + " cannot be mapped into memory; end other programs");
  data_ = static_cast<const std::byte*>(pages);
}

MappedFile::~MappedFile() {
  if (data_ != nullptr) munmap(const_cast<std::byte*>(data_), size_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}

}  // namespace bodkin
