#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bodkin::io {

// The result of a program.
struct ProgramResult {
  int exit_code = 0;   // 128 + signal if a signal ended it
  std::string output;  // standard output
  std::string errors;  // standard error
};

// Runs a program (found through PATH) to its end, with `input` as its standard input. No shell is involved: arguments
// reach the program unchanged. Throws SystemError when the program cannot be started; `package` is the Debian package
// recommended in the message.
ProgramResult run_program(const std::vector<std::string>& command, std::string_view input,
                          const std::string& package);

}  // namespace bodkin::io
