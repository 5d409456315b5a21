#pragma once

#include <memory>
#include <optional>

namespace bodkin::cli {

// Reads single keys from a terminal, without Enter, during the lifetime of this object; then restores the terminal.
// No keys if standard input is no terminal.
class TerminalKeys {
 public:
  TerminalKeys();
  ~TerminalKeys();
  TerminalKeys(const TerminalKeys&) = delete;
  TerminalKeys& operator=(const TerminalKeys&) = delete;

  // Standard input is a terminal.
  bool are_there() const noexcept { return before_ != nullptr; }
  // The next pressed key; does not wait.
  std::optional<char> next();

 private:
  struct Terminal;
  std::unique_ptr<Terminal> before_;
};

}  // namespace bodkin::cli
