#pragma once

#include <string>
#include <vector>

namespace bodkin::cli {

// Throws InputError if no window can be opened: without a display, or without bodkin-app.
void require_window();

// Replaces this process by bodkin-app with these arguments. Returns only by an exception: InputError if that program
// is not installed, SystemError if it cannot be started.
[[noreturn]] void exec_app(const std::vector<std::string>& arguments);

}  // namespace bodkin::cli
