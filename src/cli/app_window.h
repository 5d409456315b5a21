#pragma once

#include <string>
#include <vector>

namespace bodkin::cli {

// Throws InputError, in one sentence, where no window can be opened: without a display, or without bodkin-app.
void require_window();

// This process becomes bodkin-app with these arguments. Returns only by throwing InputError where that program is not
// installed, SystemError where it cannot be started.
[[noreturn]] void become_app(const std::vector<std::string>& arguments);

}  // namespace bodkin::cli
