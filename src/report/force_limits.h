#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "session/session_file.h"

#include "anatomy/case.h"

namespace bodkin::report {

// The time for which one of the governor's limits reduced the force.
struct LimitTime {
  std::uint8_t limit = 0;  // one flag of haptics::force_limit
  double time = 0.0;       // s
};

// Differences between the force on the hand and the one that the tissue asked for. A tissue stiffer than the device
// renders stably is a warning, not a limit: its force is passed on.
struct ForceLimits {
  int interventions = 0;          // number of times that the governor began to limit the force
  double time = 0.0;              // s under a limit
  std::vector<LimitTime> limits;  // those that acted; slew during its ramp counts as slew

  // For the person who held the needle; empty when it was less than 0.05 s.
  std::string sentence(const anatomy::DeviceLimits& device) const;
};

ForceLimits force_limits(const session::Session& session);

}  // namespace bodkin::report
