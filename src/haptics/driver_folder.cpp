#include "haptics/driver_folder.h"

#include <algorithm>
#include <cstdlib>

namespace bodkin::haptics {

namespace fs = std::filesystem;

fs::path driver_folder() {
  const char* named = std::getenv("BODKIN_DRIVERS");
  if (named != nullptr && *named == '/') return named;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  // An installation may have been moved as a whole: the folder next to the program is tried first.
  const fs::path relocated = self.parent_path().parent_path() / BODKIN_LIBRARY_FOLDER / "bodkin" / "drivers";
  const fs::path installed = fs::path(BODKIN_INSTALLED_LIBRARY_FOLDER) / "bodkin" / "drivers";
  return fs::is_directory(relocated, error) ? relocated : installed;
}

std::vector<std::string> driver_files() {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator at(driver_folder(), error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->path().extension() == ".so" && at->is_regular_file(ignored)) files.push_back(at->path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace bodkin::haptics
