#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "session/session_file.h"

#include "anatomy/case.h"

namespace bodkin::report {

// How long one of the governor's limits held the force back.
struct LimitTime {
  std::uint8_t limit = 0;  // one flag of haptics::force_limit
  double time = 0.0;       // s
};

// How far the hand felt another force than the tissue asked for. A tissue stiffer than the device renders stably is a
// warning and no limit: its force is passed on.
struct ForceLimits {
  int interventions = 0;          // times that the governor began to limit the force
  double time = 0.0;              // s under a limit
  std::vector<LimitTime> limits;  // those that acted; slew with its ramp counts as slew

  // For the person who held the needle; empty when it was less than 0.05 s.
  std::string sentence(const anatomy::DeviceLimits& device) const;
};

ForceLimits force_limits(const session::Session& session);

}  // namespace bodkin::report
