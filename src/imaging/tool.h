#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bodkin {

// What a finished tool (a program of its own) left.
struct ToolResult {
  int exit_code = 0;   // 128 + signal when a signal ended it
  std::string output;  // standard output
  std::string errors;  // standard error
};

// Runs a program (found through PATH) to its end, with `input` as its standard input. No shell is involved: arguments
// reach the program as they are. Throws SystemError when the program cannot be started; `package` is the Debian
// package that the message names as the cure.
ToolResult run_tool(const std::vector<std::string>& command, std::string_view input, const std::string& package);

}  // namespace bodkin
