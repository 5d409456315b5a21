#pragma once

#include "station/calibration_steps.h"

#include "cli/console.h"
#include "cli/terminal_keys.h"

namespace bodkin::cli {

// The user at the terminal, who begins each step with the Enter key and cancels with a signal; without a terminal the
// steps begin after their countdown. Both arguments must outlive the result.
station::CalibrationPerson calibration_person(Console& console, TerminalKeys& keys);

}  // namespace bodkin::cli
