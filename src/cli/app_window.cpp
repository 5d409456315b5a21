#include "cli/app_window.h"

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "core/error.h"
#include "io/worker_program.h"

namespace bodkin::cli {

namespace {

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

// Whether an X server on this machine answers. A remote one ("host:0") is not tested before use.
bool x_server_answers(std::string_view display) {
  if (!display.starts_with(':')) return true;
  int number = 0;
  std::from_chars(display.data() + 1, display.data() + display.size(), number);
  const std::string path = fmt::format("/tmp/.X11-unix/X{}", number);
  for (const bool is_abstract : {false, true}) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path + (is_abstract ? 1 : 0), sizeof address.sun_path - 2);
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size() + 1);
    const int connection = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (connection < 0) return true;
    const bool answers = connect(connection, reinterpret_cast<const sockaddr*>(&address), length) == 0;
    close(connection);
    if (answers) return true;
  }
  return false;
}

std::filesystem::path app_program() {
  try {
    std::filesystem::path found = io::find_worker({"bodkin-app", "BODKIN_APP_PROGRAM", "BODKIN_APP"});
    if (!std::filesystem::exists(found))
      throw SystemError(fmt::format("bodkin-app, the window, is not at {}", found.string()));
    return found;
  } catch (const SystemError& missing) {  // it was left out of this build of Bodkin, which is not a failure
    throw InputError(missing.what());
  }
}

}  // namespace

void require_window() {
  app_program();
  if (!variable("QT_QPA_PLATFORM").empty() || !variable("WAYLAND_DISPLAY").empty()) return;
  const std::string_view display = variable("DISPLAY");
  if (display.empty()) {
    throw InputError("there is no display to open a window on (DISPLAY and WAYLAND_DISPLAY are empty)");
  }
  if (!x_server_answers(display)) {
    throw InputError(fmt::format("the display '{}' does not answer; expected one that is open, in DISPLAY", display));
  }
}

void exec_app(const std::vector<std::string>& arguments) {
  const std::filesystem::path program = app_program();
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
  throw SystemError(fmt::format("{} cannot be started: {}", program.string(), std::strerror(errno)));
}

}  // namespace bodkin::cli
