#include "cli/terminal_keys.h"

#include <utility>

#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace bodkin::cli {

struct TerminalKeys::Terminal {
  termios settings{};
};

TerminalKeys::TerminalKeys() {
  auto before = std::make_unique<Terminal>();
  if (isatty(STDIN_FILENO) == 0 || tcgetattr(STDIN_FILENO, &before->settings) != 0) return;
  termios single = before->settings;
  single.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  if (tcsetattr(STDIN_FILENO, TCSANOW, &single) == 0) before_ = std::move(before);
}

TerminalKeys::~TerminalKeys() {
  if (before_ != nullptr) tcsetattr(STDIN_FILENO, TCSANOW, &before_->settings);
}

std::optional<char> TerminalKeys::next() {
  if (before_ == nullptr) return std::nullopt;
  pollfd waiting{STDIN_FILENO, POLLIN, 0};
  char key = 0;
  if (poll(&waiting, 1, 0) != 1 || (waiting.revents & POLLIN) == 0 || read(STDIN_FILENO, &key, 1) != 1) {
    return std::nullopt;
  }
  return key;
}

}  // namespace bodkin::cli
