#include "io/temporary_folder.h"

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include "core/error.h"

namespace bodkin::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* beginning = "bodkin-of-";  // then the number of the process, a hyphen and six random letters

// The process that made a folder of this name; 0 for names of others.
pid_t owner_of(const std::string& name) {
  if (!name.starts_with(beginning)) return 0;
  const char* first = name.c_str() + std::char_traits<char>::length(beginning);
  const char* last = name.c_str() + name.size();
  pid_t owner = 0;
  const auto [end, error] = std::from_chars(first, last, owner);
  return error == std::errc() && end != last && *end == '-' && last - end == 7 ? owner : 0;
}

// Removes the folders whose owner has ended according to `ended`.
template <typename Ended>
void remove_where(const Ended& ended) {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  if (error) return;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
    const pid_t owner = owner_of(entry->path().filename().string());
    std::error_code ignored;
    if (owner > 0 && entry->is_directory(ignored) && ended(owner)) fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  remove_where([](pid_t owner) { return kill(owner, 0) != 0 && errno == ESRCH; });
  std::string pattern = (fs::temp_directory_path() / fmt::format("{}{}-XXXXXX", beginning, getpid())).string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw SystemError(fmt::format("no temporary folder can be made in {}; set TMPDIR to a folder with room",
                                  fs::temp_directory_path().string()));
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void remove_temporary_folders(pid_t owner) noexcept {
  try {
    remove_where([owner](pid_t each) { return each == owner; });
  } catch (const std::exception&) {  // what cannot be removed now is removed by the next run
  }
}

}  // namespace bodkin::io
