#pragma once

#include <functional>
#include <string_view>

namespace bodkin {

// Reports the progress of long work: the name of the present stage and its fraction done, 0 to 1. Called from the
// working thread, at most a few dozen times a second. May be empty: no progress is shown.
using Progress = std::function<void(std::string_view stage, double fraction)>;

}  // namespace bodkin
