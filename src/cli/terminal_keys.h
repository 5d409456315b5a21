#pragma once

#include <memory>
#include <optional>

namespace bodkin::cli {

// Single keys from a terminal, without Enter, for as long as this lives; the terminal is then as it was. Where
// standard input is no terminal there are none.
class TerminalKeys {
 public:
  TerminalKeys();
  ~TerminalKeys();
  TerminalKeys(const TerminalKeys&) = delete;
  TerminalKeys& operator=(const TerminalKeys&) = delete;

  // There is a terminal.
  bool are_there() const noexcept { return before_ != nullptr; }
  // The next key that was pressed; does not wait.
  std::optional<char> next();

 private:
  struct Terminal;
  std::unique_ptr<Terminal> before_;
};

}  // namespace bodkin::cli
