#include "io/resources.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::io {

namespace fs = std::filesystem;

fs::path shared_file(const std::string& name) {
  std::vector<fs::path> folders;
  if (const char* chosen = std::getenv("BODKIN_SHARE"); chosen != nullptr && *chosen != '\0')
    folders.emplace_back(chosen);
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) folders.push_back(program.parent_path().parent_path() / "share" / "bodkin");
  folders.emplace_back(BODKIN_SOURCE_SHARE);
  folders.emplace_back(BODKIN_INSTALLED_SHARE);
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / name, ignored)) return folder / name;
  }
  throw SystemError(
      fmt::format("'{}' is missing from this installation of Bodkin (looked in {}); install Bodkin again, or let "
                  "BODKIN_SHARE name the folder share/bodkin",
                  name, folders.front().string()));
}

std::string read_text_file(const fs::path& file, std::size_t limit) {
  std::error_code failed;
  const fs::file_status status = fs::status(file, failed);
  if (!fs::exists(status)) throw InputError(fmt::format("{}: there is no such file", file.string()));
  if (!fs::is_regular_file(status)) throw InputError(fmt::format("{}: this is not a file", file.string()));
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: the file cannot be opened for reading", file.string()));
  // Reads to the end instead of trusting the size, which is wrong for a file in /proc or a growing file.
  std::string text;
  char block[65536];
  while (text.size() <= limit && (stream.read(block, sizeof block), stream.gcount() > 0)) {
    text.append(block, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw InputError(fmt::format("{}: the file cannot be read to its end", file.string()));
  if (text.size() > limit) {
    throw InputError(
        fmt::format("{}: the file is larger than the {} kB that such a file may have", file.string(), limit / 1024));
  }
  return text;
}

bool is_inside_name(const std::string& name) {
  if (name.empty() || name.find('\0') != std::string::npos || name.find('\\') != std::string::npos) return false;
  const fs::path path(name);
  return path.is_relative() && path.has_filename() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".." || part == "."; });
}

fs::path file_inside(const fs::path& folder, const std::string& name, const std::string& what) {
  if (!is_inside_name(name)) {
    throw InputError(fmt::format(
        "{} is '{}', expected a file name inside the case folder, without '..' or a leading '/'", what, name));
  }
  std::error_code failed;
  fs::path file = folder / name;
  if (!fs::exists(file, failed))
    throw InputError(fmt::format("{} is '{}', but {} does not exist", what, name, file.string()));
  const fs::path root = fs::canonical(folder, failed);
  const fs::path real = failed ? fs::path() : fs::canonical(file, failed);
  const bool inside =
      !failed && std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
  if (!inside)
    throw InputError(
        fmt::format("{} is '{}', a link that leads out of the case folder; put the file itself there", what, name));
  if (!fs::is_regular_file(real, failed))
    throw InputError(fmt::format("{} is '{}', which is not a file", what, name));
  return file;
}

}  // namespace bodkin::io
