#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace bodkin {

// A file's bytes in memory, read alone: the system brings them when they are looked at, shares them between programs,
// and takes the memory back when it needs it. A file that is replaced by another of its name is kept until the end;
// one that is cut off meanwhile ends the program.
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

  // Begins at a multiple of the size of a page.
  std::span<const std::byte> bytes() const noexcept { return {data_, size_}; }

 private:
  const std::byte* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace bodkin
