#include "core/files.h"

#include <fstream>
#include <string>
#include <system_error>

#include <unistd.h>

#include "core/error.h"

namespace bodkin {

namespace fs = std::filesystem;

void write_file(const fs::path& file, std::string_view bytes) {
  std::error_code problem;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), problem);
  fs::path unfinished = file;
  unfinished += '.';
  unfinished += std::to_string(getpid());
  unfinished += ".part";
  std::ofstream stream(unfinished, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
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
