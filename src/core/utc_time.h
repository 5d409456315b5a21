#pragma once

#include <string>

namespace bodkin {

// The present time in ISO 8601, UTC, to the second: "2026-11-22T04:30:00Z".
std::string utc_now();

}  // namespace bodkin
