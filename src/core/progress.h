#pragma once

#include <functional>
#include <string_view>

namespace bodkin {

// Long work reports where it is: the name of the present stage and its fraction done, 0 to 1. Called from the working
// thread, at most a few dozen times a second. An empty function is allowed: no progress is shown.
using Progress = std::function<void(std::string_view stage, double fraction)>;

}  // namespace bodkin
