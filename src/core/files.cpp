#include "core/files.h"

#include <atomic>
#include <fstream>
#include <string>
#include <system_error>

#include <unistd.h>

#include "core/error.h"

namespace bodkin {

namespace fs = std::filesystem;

void write_file(const fs::path& file, std::string_view bytes) {
  write_file(file, std::span(&bytes, 1));
}

void write_file(const fs::path& file, std::span<const std::string_view> pieces) {
  static std::atomic<unsigned> written = 0;
  std::error_code problem;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), problem);
  fs::path unfinished = file;
  unfinished += '.';
  unfinished += std::to_string(getpid());
  unfinished += '.';
  unfinished += std::to_string(written.fetch_add(1));  // two threads may write at once
  unfinished += ".part";
  std::ofstream stream(unfinished, std::ios::binary | std::ios::trunc);
  for (const std::string_view piece : pieces) stream.write(piece.data(), static_cast<std::streamsize>(piece.size()));
  stream.close();
  if (stream) {
    fs::rename(unfinished, file, problem);
    if (!problem) return;
  }
  std::error_code ignored;
  fs::remove(unfinished, ignored);
  throw SystemError(file.string() + " cannot be written; is the folder there, writable and not full?");
}

}  // namespace bodkin
