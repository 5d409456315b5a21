#include "app/models/data_folder.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "core/utc_time.h"
#include "io/data_folder.h"

namespace bodkin::app {

namespace fs = std::filesystem;

fs::path data_folder() {
  return io::data_folder();
}

fs::path new_session_file(const std::string& patient) {
  const fs::path folder = data_folder() / "sessions";
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw SystemError(fmt::format("{} cannot be made: {}; free space there or set XDG_DATA_HOME", folder.string(),
                                  failure.message()));
  }
  std::string name = patient;
  std::replace(name.begin(), name.end(), '/', '-');
  const std::string day = utc_now().substr(0, 10);
  for (int number = 1;; ++number) {
    fs::path file = folder / fmt::format("{} {} {}.bodkin", day, name, number);
    if (!fs::exists(file)) return file;
  }
}

}  // namespace bodkin::app
