#include "io/data_folder.h"

#include <cstdlib>

namespace bodkin::io {

namespace fs = std::filesystem;

fs::path data_folder() {
  if (const char* const data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data == '/')
    return fs::path(data) / "bodkin";
  const char* const home = std::getenv("HOME");
  return fs::path(home == nullptr ? "." : home) / ".local" / "share" / "bodkin";
}

}  // namespace bodkin::io
