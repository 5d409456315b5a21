#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace bodkin {

// A file's bytes in memory, read-only: the system loads them on access, shares them between programs, and reclaims
// the memory when needed. The content stays when the file is replaced by another of its name; a file that is
// truncated meanwhile ends the program.
class MappedFile {
 public:
  MappedFile() = default;
  // Throws InputError, naming the file, when it cannot be opened or mapped.
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  // Begins at a multiple of the page size.
  std::span<const std::byte> bytes() const noexcept { return {data_, size_}; }

 private:
  const std::byte* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace bodkin
