#include "io/partial_folder.h"

#include <cerrno>
#include <charconv>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include "core/error.h"

namespace bodkin::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* infix = ".partial-";

// "patient/" and "patient" are the same place.
fs::path without_trailing_slash(const fs::path& path) {
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

bool still_runs(const std::string& digits) {
  pid_t owner = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), owner);
  if (error != std::errc() || end != digits.data() + digits.size() || owner <= 0) return true;  // not one of ours
  return kill(owner, 0) == 0 || errno != ESRCH;
}

void remove_left_behind(const fs::path& final) {
  const std::string prefix = final.filename().string() + infix;
  std::error_code error;
  for (fs::directory_iterator entry(final.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(prefix) || still_runs(name.substr(prefix.size()))) continue;
    std::error_code ignored;
    fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace

fs::path partial_name(const fs::path& final, pid_t owner) {
  fs::path name = without_trailing_slash(final);
  name += fmt::format("{}{}", infix, owner);
  return name;
}

PartialFolder::PartialFolder(const fs::path& final, bool overwrite)
    : final_(without_trailing_slash(final)), partial_(partial_name(final, getpid())) {
  if (!fs::is_directory(final_.parent_path())) {
    throw InputError(fmt::format("{}: the folder {} in which the case should be made does not exist; make it first",
                                 final.string(), final_.parent_path().string()));
  }
  if (fs::exists(fs::symlink_status(final_))) {
    if (!overwrite) {
      throw InputError(fmt::format(
          "{}: this is already there; choose another folder, or say --overwrite to replace it", final.string()));
    }
    // Only a case is ever deleted, whatever a mistyped name refers to.
    if (!fs::is_directory(fs::symlink_status(final_)) || !fs::exists(final_ / "case.xml")) {
      throw InputError(
          fmt::format("{}: --overwrite replaces only a case folder, and this has no case.xml", final.string()));
    }
  }
  remove_left_behind(final_);
  std::error_code error;
  fs::remove_all(partial_, error);
  if (!fs::create_directory(partial_, error)) {
    throw SystemError(fmt::format("{} cannot be made: {}", partial_.string(), error.message()));
  }
}

PartialFolder::~PartialFolder() {
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
}

void PartialFolder::finish() {
  std::error_code error;
  if (fs::exists(final_)) {
    fs::path old = final_;
    old += fmt::format("{}{}", infix, getpid());
    old += "-old";
    fs::rename(final_, old, error);
    if (!error) fs::rename(partial_, final_, error);
    if (error) {
      std::error_code ignored;
      if (!fs::exists(final_)) fs::rename(old, final_, ignored);
    } else {
      std::error_code ignored;
      fs::remove_all(old, ignored);
    }
  } else {
    fs::rename(partial_, final_, error);
  }
  if (error) throw SystemError(fmt::format("{} cannot be put in its place: {}", final_.string(), error.message()));
}

}  // namespace bodkin::io
