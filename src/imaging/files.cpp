#include "imaging/files.h"

#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "core/error.h"

namespace bodkin {

namespace fs = std::filesystem;

void write_file(const fs::path& file, std::string_view bytes) {
  std::error_code problem;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), problem);
  fs::path unfinished = file;
  unfinished += fmt::format(".{}.part", getpid());
  std::ofstream stream(unfinished, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) {
    fs::rename(unfinished, file, problem);
    if (!problem) return;
  }
  std::error_code ignored;
  fs::remove(unfinished, ignored);
  throw SystemError(fmt::format("{} cannot be written; is the folder there, writable and not full?", file.string()));
}

}  // namespace bodkin
