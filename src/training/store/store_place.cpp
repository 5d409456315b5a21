#include "training/store/store_place.h"

#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "io/data_folder.h"

namespace bodkin::training {

namespace {

namespace fs = std::filesystem;

fs::path made_data_folder() {
  fs::path folder = io::data_folder();
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!failure) return folder;
  throw SystemError(fmt::format("{} cannot be made: {}; free space there or set XDG_DATA_HOME", folder.string(),
                                failure.message()));
}

}  // namespace

std::string store_place(const std::string& given) {
  if (!given.empty()) return given;
  const char* const chosen = std::getenv("BODKIN_STORE");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  return (made_data_folder() / "results.sqlite").string();
}

fs::path outbox_folder() {
  return made_data_folder() / "outbox";
}

}  // namespace bodkin::training
